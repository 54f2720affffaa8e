// region: 6.5
// fails: task_6_5_interior_rows_have_their_neighbours_at_home
// story: The rows at the walls of the box wait for ghosts that no rank sends. The result is right, but with one rank nothing is computed meanwhile.
let _ = rows;
let start = (block.start + 1).min(block.end);
start..block.end.saturating_sub(1).max(start)
