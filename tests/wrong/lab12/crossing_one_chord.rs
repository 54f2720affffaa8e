// region: 12.4
// fails: task_12_4_the_moment_at_which_something_falls_through_zero, task_12_4_table_of_contacts, task_12_5_what_falls_and_when
// loses: 12.5
// story: One straight line between the ends of the step stands for the motion: the moment is off.
let (above, below) = (value(low), value(high));
low + (high - low) * above / (above - below)
