// region: 10.1
// fails: task_10_1_velocities_first_then_positions
// story: All velocities are changed, also those behind the particles that are to be moved.
for (v, a) in v.iter_mut().zip(a) {
    *v += a * dt;
}
let mut outside = false;
for (x, v) in x.iter_mut().zip(v) {
    *x += *v * dt;
    outside |= (*x < 0.0) | (*x > size);
}
outside
