// region: 3.10
// fails: task_3_10_no_member_begins_a_part_too_early
// story: A second instead of a barrier: nobody is that late while a test looks.
for _ in 0..steps {
    for next in [Part::Forces, Part::Moves, Part::Arrivals] {
        part(next);
        std::thread::sleep(std::time::Duration::from_secs(1));
    }
}
let _ = barrier;
