// region: 3.8
// fails: task_3_8_nobody_begins_a_part_too_early, task_3_8_a_late_member_changes_nothing
// story: Who is done begins the next step and reads bins that their owner is still sorting.
part(Part::Forces);
barrier.wait();
part(Part::Moves);
barrier.wait();
part(Part::Arrivals);
