// region: 10.6
// fails: task_10_6_closest_approach
// story: The line is endless: a meeting before or after the window counts as one within.
let t = -(dx * wx + dy * wy) / (wx * wx + wy * wy);
let t = if t.is_nan() { larger(0.0, -span) } else { t };
let (x, y) = (dx + t * wx, dy + t * wy);
x * x + y * y
