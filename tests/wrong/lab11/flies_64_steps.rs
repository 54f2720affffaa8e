// region: 11.1
// fails: task_11_1_free_flight_adds_step_by_step
// story: Flies 64 steps at most.
for (x, v) in x.iter_mut().zip(v) {
    (0..steps.min(64)).for_each(|_| *x += v * dt);
}
