// region: 2.1
// fails: task_2_1_bins_are_as_wide_as_asked_for
// story: The most bins allowed are taken along one wall and not in all: the square of it in a wide box.
let fit = size / (least * (1.0 + MARGIN));
let most = BINS_PER_PARTICLE as f64 * n as f64;
(fit.min(most) as usize).max(1)
