// region: 7.11
// fails: task_7_11_the_box_of_a_window
// story: The box is rounded to single precision.
let (start, end) = (x + v * window.from, x + v * window.to.min(1.0));
Span { low: f64::from((start.min(end) - reach) as f32), high: f64::from((start.max(end) + reach) as f32) }
