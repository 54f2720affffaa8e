// region: 13.8
// fails: task_13_8_steps_are_right_until_the_ghosts_are_used_up
// story: The move after the last forces is counted: an epoch is taken again whose forces were all right.
let mut reach = 0.0;
let right = moves.iter().take_while(|far| {
    reach += CUTOFF + 2.0 * **far;
    reach <= width
});
right.count().max(1)
