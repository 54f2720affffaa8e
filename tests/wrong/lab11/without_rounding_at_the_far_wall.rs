// region: 11.5
// fails: task_11_5_a_wall_within_the_window
// story: At the far wall rounding is forgotten.
let (end_x, end_y) = (x + vx * span.whole(), y + vy * span.whole());
let (least, most) = (span.rounding(), span.size);
// Not the other way round: a number that is NaN meets the wall.
!((end_x >= least) & (end_x <= most) & (end_y >= least) & (end_y <= most))
