// region: 11.2
// fails: task_11_2_closest_approach
// story: The moment is computed in single precision.
let t = -(dx * wx + dy * wy) / (wx * wx + wy * wy);
let t = larger(f64::from(t as f32), 0.0);
let t = if t < span { t } else { span };
let (x, y) = (dx + t * wx, dy + t * wy);
x * x + y * y
