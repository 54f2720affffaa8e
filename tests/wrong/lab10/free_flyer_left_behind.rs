// region: 10.7
// fails: task_10_7_free_flight_adds_step_by_step, task_10_6_windows_have_the_bits_of_all_pairs
// story: Free flyers are advanced by one step whatever the window.
for (x, v) in x.iter_mut().zip(v) {
    if steps > 0 {
        *x += v * dt;
    }
}
