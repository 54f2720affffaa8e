// region: 11.6
// fails: task_11_6_window_lengths
// story: The longest window for every scene.
let _ = (density, speed);
LONGEST
