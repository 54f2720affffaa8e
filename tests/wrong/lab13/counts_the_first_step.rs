// region: 13.1
// fails: task_13_1_two_meet_across_the_border, task_13_1_table_of_widths
// story: Ghosts for one step are wider than the cutoff, although no particle has moved when its forces are computed. The result is right, with more ghosts than needed.
CUTOFF + 2.0 * f64::from(steps) * fastest
