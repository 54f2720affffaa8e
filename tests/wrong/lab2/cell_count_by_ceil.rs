// region: 2.1
// fails: task_2_1_bins_are_as_wide_as_asked_for
// story: The number of bins is rounded up, so that the last row fits: now every bin is narrower than the cutoff.
let fit = size / (least * (1.0 + MARGIN));
let most = (BINS_PER_PARTICLE as f64 * n as f64).sqrt();
(fit.min(most).ceil() as usize).max(1)
