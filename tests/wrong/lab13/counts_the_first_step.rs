// region: 13.1
// fails: task_13_1_ghosts_are_as_wide_as_two_move, task_13_1_table_of_widths
// story: Ghosts for one step are wider than the cutoff, although no particle has moved when its forces are computed. The result is right, with more ghosts than needed.
CUTOFF + 2.0 * f64::from(steps) * fastest
