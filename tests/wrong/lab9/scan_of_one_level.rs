// region: 9.6b
// fails: task_9_6_prefix_sums_of_any_length
// story: The sums of blocks are never added back: right for as many numbers as one workgroup has threads.
        for level in &scan.levels {
            work.launch(&level.scan_blocks, level.launch);
        }
