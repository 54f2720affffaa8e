// region: 12.4
// fails: task_12_4_what_falls_and_when
// story: Only the two ends of the step are compared: a pair that comes into reach and leaves it within one is overlooked.
(start.value >= 0.0 && end.value < 0.0).then(|| crossing(0.0, h, &mut |t| at(t).value))
