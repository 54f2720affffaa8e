// region: 3.10
// fails: task_3_10_no_member_begins_a_part_too_early, task_3_11_a_late_member_changes_nothing
// story: A member that is done begins the next step and reads bins that their owner is still sorting.
for _ in 0..steps {
    part(Part::Forces);
    barrier.wait();
    part(Part::Moves);
    barrier.wait();
    part(Part::Arrivals);
}
