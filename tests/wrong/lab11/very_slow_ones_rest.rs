// region: 11.2
// fails: task_11_2_closest_approach
// story: Very slow particles count as resting.
let t = -(dx * wx + dy * wy) / (wx * wx + wy * wy);
let t = if wx * wx + wy * wy < 1e-18 { 0.0 } else { larger(t, 0.0) };
let t = if t < span { t } else { span };
let (x, y) = (dx + t * wx, dy + t * wy);
x * x + y * y
