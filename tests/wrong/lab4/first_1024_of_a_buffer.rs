// region: 4.6
// fails: task_4_6_one_thread_empties_all_buffers
// story: Of a buffer 1,024 changes are made.
for buffer in buffers {
    for change in buffer.iter().take(1024) {
        remove(regions.bin_mut(change.from), change.particle);
        regions.bin_mut(change.to).push(change.particle);
    }
}
