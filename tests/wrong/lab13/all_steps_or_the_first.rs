// region: 13.8
// fails: task_13_8_steps_are_right_until_the_ghosts_are_used_up, task_13_8_all_ranks_go_back_or_none
// story: If one step is wrong, all but the first are taken again: the result is right, and late kicks cost whole epochs.
let before = &moves[..moves.len() - 1];
let reach = moves.len() as f64 * CUTOFF + 2.0 * before.iter().sum::<f64>();
if reach <= width { moves.len() } else { 1 }
