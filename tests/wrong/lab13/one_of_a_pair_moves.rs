// region: 13.1
// fails: task_13_1_ghosts_are_as_wide_as_two_move, task_13_1_table_of_widths
// story: Only one of a pair is thought to move: two that fly towards each other meet before the ghosts have expired.
CUTOFF + f64::from(steps - 1) * fastest
