// region: 10.1
// fails: task_10_1_velocities_first_then_positions
// loses: 10.6
// story: Eight at a time, and the last few that make no eight are forgotten.
let mut outside = false;
for ((x, v), a) in x.chunks_exact_mut(8).zip(v.chunks_mut(8)).zip(a.chunks(8)) {
    for l in 0..8 {
        v[l] += a[l] * dt;
        x[l] += v[l] * dt;
        outside |= (x[l] < 0.0) | (x[l] > size);
    }
}
outside
