// region: 2.1
// fails: task_2_1_bins_are_as_wide_as_asked_for
// story: Eight bins for each particle, computed in 32 bits.
let fit = size / (least * (1.0 + MARGIN));
let most = f64::from((BINS_PER_PARTICLE as u32).wrapping_mul(n as u32)).sqrt();
(fit.min(most) as usize).max(1)
