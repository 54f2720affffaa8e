// region: 11.1
// fails: task_11_1_free_flight_adds_step_by_step
// story: Particles slower than 1e-9 stay.
for (x, v) in x.iter_mut().zip(v) {
    if v.abs() > 1e-9 {
        (0..steps).for_each(|_| *x += v * dt);
    }
}
