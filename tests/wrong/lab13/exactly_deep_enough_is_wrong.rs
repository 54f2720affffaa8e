// region: 13.8
// fails: task_13_8_steps_are_right_until_the_ghosts_are_used_up
// story: At exactly the width a step counts as wrong.
let mut reach = CUTOFF;
let mut right = 1;
for far in &moves[..moves.len() - 1] {
    reach += CUTOFF + 2.0 * far;
    if reach >= width {
        break;
    }
    right += 1;
}
right
