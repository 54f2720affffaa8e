// region: 11.1
// fails: task_11_1_free_flight_adds_step_by_step
// story: Steps are counted in 16 bits: of 65,536 none is flown.
for (x, v) in x.iter_mut().zip(v) {
    for _ in 0..steps as u16 {
        *x += v * dt;
    }
}
