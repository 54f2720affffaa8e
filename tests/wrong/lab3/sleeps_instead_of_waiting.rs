// region: 3.10
// fails: task_3_10_no_member_begins_a_part_too_early, task_3_11_a_late_member_changes_nothing
// story: Two milliseconds are enough for the others, on most days.
for _ in 0..steps {
    for next in [Part::Forces, Part::Moves, Part::Arrivals] {
        part(next);
        std::thread::sleep(std::time::Duration::from_millis(2));
    }
}
let _ = barrier;
