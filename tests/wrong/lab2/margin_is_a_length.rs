// region: 2.1
// fails: task_2_1_bins_are_as_wide_as_asked_for
// story: The margin is added to the least side as if it were a length.
let fit = size / (least + MARGIN);
let most = (BINS_PER_PARTICLE as f64 * n as f64).sqrt();
(fit.min(most) as usize).max(1)
