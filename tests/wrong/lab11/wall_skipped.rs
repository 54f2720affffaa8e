// region: 11.5
// fails: task_11_5_a_wall_within_the_window, task_11_5_windows_have_the_bits_of_all_pairs
// story: Only where the particle is now counts, so one that reaches the wall within the window flies through it.
let _ = (vx, vy);
!((x >= 0.0) & (x <= span.size) & (y >= 0.0) & (y <= span.size))
