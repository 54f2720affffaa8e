// region: 11.1
// fails: task_11_1_free_flight_adds_step_by_step
// story: Flies with the official step whatever dt.
let dt = if dt > 0.0 { common::soft::DT } else { dt };
for (x, v) in x.iter_mut().zip(v) {
    (0..steps).for_each(|_| *x += v * dt);
}
