// region: 11.2
// fails: task_11_2_closest_approach
// story: The line is endless: a meeting before or after the window counts as one within.
let t = -(dx * wx + dy * wy) / (wx * wx + wy * wy);
let t = if t.is_nan() { larger(0.0, -span) } else { t };
let (x, y) = (dx + t * wx, dy + t * wy);
x * x + y * y
