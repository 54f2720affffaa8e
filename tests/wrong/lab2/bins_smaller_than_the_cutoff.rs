// region: 2.1
// fails: task_2_1_bins_are_as_wide_as_asked_for
// story: Bins are made a tenth narrower than asked for: fewer pair tests, and some pairs are two bins apart.
let fit = size / (0.9 * least);
let most = (BINS_PER_PARTICLE as f64 * n as f64).sqrt();
(fit.min(most) as usize).max(1)
