// region: 13.7
// fails: task_13_7_what_is_wrong_comes_nearer, task_13_7_table_of_depths
// story: Only one of a pair is thought to move: what is wrong comes nearer, and the own particle does not go to meet it.
f64::from(steps) * CUTOFF + f64::from(steps - 1) * fastest
