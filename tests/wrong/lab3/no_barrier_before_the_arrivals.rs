// region: 3.10
// fails: task_3_10_no_member_begins_a_part_too_early, task_3_11_a_late_member_changes_nothing
// story: A member that has moved takes its mail at once, when not all letters are posted. They arrive a step late.
for _ in 0..steps {
    part(Part::Forces);
    barrier.wait();
    part(Part::Moves);
    part(Part::Arrivals);
    barrier.wait();
}
