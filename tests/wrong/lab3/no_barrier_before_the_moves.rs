// region: 3.10
// fails: task_3_10_no_member_begins_a_part_too_early, task_3_11_a_late_member_changes_nothing
// story: The first to have its forces moves its particles while other members still read where they were.
for _ in 0..steps {
    part(Part::Forces);
    part(Part::Moves);
    barrier.wait();
    part(Part::Arrivals);
    barrier.wait();
}
