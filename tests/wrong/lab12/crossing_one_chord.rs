// region: 12.3
// fails: task_12_3_the_moment_at_which_something_falls_through_zero, task_12_3_table_of_contacts, task_12_4_what_falls_and_when
// loses: 12.4
// story: One straight line between the ends of the step stands for the motion: the moment is off.
let (above, below) = (value(low), value(high));
low + (high - low) * above / (above - below)
