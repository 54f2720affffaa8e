// region: 7.11
// fails: task_7_11_the_box_of_a_window
// story: A disc slower than 1e-9 is taken for one at rest.
let v = if v.abs() < 1e-9 { 0.0 } else { v };
let (start, end) = (x + v * window.from, x + v * window.to.min(1.0));
Span { low: start.min(end) - reach, high: start.max(end) + reach }
