// region: 10.12
// fails: task_10_12_the_moment_at_which_something_falls_through_zero
// story: One straight line between the ends of the step stands for the motion: the moment is off.
let (above, below) = (value(low), value(high));
low + (high - low) * above / (above - below)
