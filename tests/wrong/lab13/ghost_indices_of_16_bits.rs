// region: 13.3
// fails: task_13_3_ghosts_are_near_the_strip
// story: Indices in 16 bits.
let is_near = |y: f64| strip.start - y <= width && y - strip.end <= width;
(0..).zip(y).filter(|(_, y)| is_near(**y)).map(|(index, _)| index & 0xffff).collect()
