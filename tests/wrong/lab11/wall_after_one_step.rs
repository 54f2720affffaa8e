// region: 11.5
// fails: task_11_5_a_wall_within_the_window, task_11_5_windows_have_the_bits_of_all_pairs
// story: The wall is looked for one step ahead, the window is longer.
let (end_x, end_y) = (x + vx * span.dt, y + vy * span.dt);
!((end_x >= 0.0) & (end_x <= span.size) & (end_y >= 0.0) & (end_y <= span.size))
