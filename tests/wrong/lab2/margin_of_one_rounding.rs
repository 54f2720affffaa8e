// region: 2.1
// fails: task_2_1_bins_are_as_wide_as_asked_for
// story: Bins are one rounding wider than asked for, which the other roundings use up: a pair at the cutoff is two bins apart.
let fit = size / least.next_up();
let most = (BINS_PER_PARTICLE as f64 * n as f64).sqrt();
(fit.min(most) as usize).max(1)
