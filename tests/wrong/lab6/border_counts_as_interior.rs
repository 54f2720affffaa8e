// region: 6.5
// fails: task_6_5_interior_rows_have_their_neighbours_at_home
// loses: 6.7
// story: The last row of the block is taken for an interior one, so that its forces are computed before its ghosts are there.
let start = if block.start == 0 { 0 } else { (block.start + 1).min(block.end) };
let _ = rows;
start..block.end
