// region: 13.3
// fails: task_13_3_ghosts_are_near_the_strip
// loses: 13.6
// story: Particles above the strip are forgotten: a rank sends ghosts to the rank after it and none to the rank before.
let is_near = |y: f64| y <= strip.start && strip.start - y <= width;
(0..).zip(y).filter(|(_, y)| is_near(**y)).map(|(index, _)| index).collect()
