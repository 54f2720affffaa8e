// region: 2.1
// fails: task_2_1_bins_are_as_wide_as_asked_for
// story: No more than 4,096 bins along a wall, however large the box and however many the particles.
let fit = size / (least * (1.0 + MARGIN));
let most = (BINS_PER_PARTICLE as f64 * n as f64).sqrt();
(fit.min(most) as usize).clamp(1, 4096)
