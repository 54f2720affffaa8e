// region: 8.1
// fails: task_8_1_few_blocks_make_every_distance
// story: «About √W blocks are enough»: the first √W + 1 of them are neighbours, and no two of these are far apart.
(0..workers).take(workers.isqrt() + 1).collect()
