// region: 13.1
// fails: task_13_1_ghosts_are_as_wide_as_two_move
// story: A speed below 1e-9 counts as rest.
if fastest < 1e-9 {
    return CUTOFF;
}
CUTOFF + 2.0 * f64::from(steps - 1) * fastest
