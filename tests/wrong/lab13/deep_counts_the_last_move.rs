// region: 13.7
// fails: task_13_7_what_is_wrong_comes_nearer, task_13_7_table_of_depths
// story: Ghosts are chosen for a move more than matters: after the last forces no particle is pushed any more. The result is right, with more ghosts than needed.
f64::from(steps) * (CUTOFF + 2.0 * fastest)
