// region: 13.7
// fails: task_13_7_what_is_wrong_comes_nearer, task_13_7_table_of_depths, task_13_8_far_fewer_messages_than_steps
// story: As wide as ghosts whose positions are sent in each step: it is forgotten that what is wrong comes nearer by a cutoff in each step. All ranks go back in every epoch, so the result is right.
CUTOFF + 2.0 * f64::from(steps - 1) * fastest
