// region: 13.8b
// fails: task_13_8_all_ranks_go_back_or_none
// story: Each rank looks at its own particles: one goes back, and its neighbour, whose ghosts are now of another step, does not.
let _ = (world.rank(), SystemOperation::max());
right_steps(&said[..steps], width)
