// region: 10.1
// fails: task_10_1_velocities_first_then_positions
// loses: 10.6
// story: The loop returns at the first particle outside the walls; those behind it do not move.
for ((x, v), a) in x.iter_mut().zip(v).zip(a) {
    *v += a * dt;
    *x += *v * dt;
    if *x < 0.0 || *x > size {
        return true;
    }
}
false
