// region: 10.1
// fails: task_10_1_outside_is_beyond_either_wall
// loses: 10.6
// story: Only the wall at zero is looked at.
let _ = size;
let mut outside = false;
for ((x, v), a) in x.iter_mut().zip(v).zip(a) {
    *v += a * dt;
    *x += *v * dt;
    outside |= *x < 0.0;
}
outside
