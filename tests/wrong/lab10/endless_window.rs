// region: 10.9
// fails: task_10_9_window_lengths
// story: The longest window for everybody.
let _ = (density, speed);
LONGEST
