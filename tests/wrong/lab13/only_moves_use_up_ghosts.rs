// region: 13.8
// fails: task_13_8_steps_are_right_until_the_ghosts_are_used_up, task_13_8_all_ranks_go_back_or_none
// story: Only moves are subtracted from the depth of ghosts, and not the cutoff that each computation of forces costs: an epoch stands in which particles have used the spare of many cutoffs.
let mut reach = CUTOFF;
let mut right = 1;
for far in &moves[..moves.len() - 1] {
    reach += 2.0 * far;
    if reach > width {
        break;
    }
    right += 1;
}
right
