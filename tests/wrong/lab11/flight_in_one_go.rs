// region: 11.1
// fails: task_11_1_free_flight_adds_step_by_step
// story: All steps at once, x + steps v dt: right on paper, another last digit than step by step.
for (x, v) in x.iter_mut().zip(v) {
    *x += v * (f64::from(steps) * dt);
}
