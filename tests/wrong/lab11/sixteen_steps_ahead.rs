// region: 11.5
// fails: task_11_5_a_wall_within_the_window
// story: Looks sixteen steps ahead at most.
let (end_x, end_y) = (x + vx * span.whole().min(16.0 * common::soft::DT), y + vy * span.whole().min(16.0 * common::soft::DT));
let (least, most) = (span.rounding(), span.size - span.rounding());
// Not the other way round: a number that is NaN meets the wall.
!((end_x >= least) & (end_x <= most) & (end_y >= least) & (end_y <= most))
