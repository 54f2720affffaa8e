// region: 2.1
// fails: task_2_1_bins_are_as_wide_as_asked_for
// story: Bins are exactly as wide as asked for, and rounding puts a pair at the cutoff two bins apart.
let fit = size / least;
let most = (BINS_PER_PARTICLE as f64 * n as f64).sqrt();
(fit.min(most) as usize).max(1)
