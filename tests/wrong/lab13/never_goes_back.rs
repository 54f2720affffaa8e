// region: 13.8
// fails: task_13_8_steps_are_right_until_the_ghosts_are_used_up, task_13_8_all_ranks_go_back_or_none, task_13_8_a_kick_in_the_middle_of_an_epoch
// story: Every epoch stands, whatever became of the particles in it: one that was kicked flies into a strip whose rank did not know it.
let _ = (width, CUTOFF);
moves.len()
