// region: 13.1
// fails: task_13_1_ghosts_are_as_wide_as_two_move
// story: No more than 64 steps.
CUTOFF + 2.0 * f64::from(steps.min(65) - 1) * fastest
