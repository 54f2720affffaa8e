// region: 11.1
// fails: task_11_1_free_flight_adds_step_by_step, task_11_5_windows_have_the_bits_of_all_pairs
// story: Free particles are advanced by one step whatever the window.
for (x, v) in x.iter_mut().zip(v) {
    if steps > 0 {
        *x += v * dt;
    }
}
