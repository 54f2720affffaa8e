// region: 11.6
// fails: task_11_6_window_lengths
// story: A speed below 1e-6 counts as rest.
if speed < 1e-6 {
    return LONGEST;
}
let a_step = 2.0 * CUTOFF * SQRT_2 * speed * DT * density;
if a_step * f64::from(LONGEST) <= SWEPT {
    return LONGEST;
}
((SWEPT / a_step) as u32).clamp(1, LONGEST)
