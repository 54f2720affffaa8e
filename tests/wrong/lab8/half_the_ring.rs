// region: 8.1
// fails: task_8_1_few_blocks_make_every_distance
// story: Every worker gets half the ring. That is right, and with 128 workers four times the bytes that are needed.
(0..=workers / 2).collect()
