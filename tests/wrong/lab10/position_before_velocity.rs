// region: 10.1
// fails: task_10_1_velocities_first_then_positions
// loses: 10.6
// story: The position moves with the old velocity: explicit Euler, which gains energy.
let mut outside = false;
for ((x, v), a) in x.iter_mut().zip(v).zip(a) {
    *x += *v * dt;
    *v += a * dt;
    outside |= (*x < 0.0) | (*x > size);
}
outside
