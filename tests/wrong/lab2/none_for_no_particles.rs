// region: 2.1
// fails: task_2_1_bins_are_as_wide_as_asked_for
// story: At least one bin is asked for before the number is cut to what memory allows: without particles, n = 0, there is no bin.
let fit = (size / (least * (1.0 + MARGIN))).max(1.0);
let most = (BINS_PER_PARTICLE as f64 * n as f64).sqrt();
fit.min(most) as usize
