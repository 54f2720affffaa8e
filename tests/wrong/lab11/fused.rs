// region: 11.1
// fails: task_11_1_free_flight_adds_step_by_step
// story: A fused multiply and add rounds once instead of twice.
for (x, v) in x.iter_mut().zip(v) {
    (0..steps).for_each(|_| *x = v.mul_add(dt, *x));
}
