// region: 3.8
// fails: task_3_8_nobody_begins_a_part_too_early, task_3_8_a_late_member_changes_nothing
// story: The first to have its forces moves its particles while others still read where they were.
part(Part::Forces);
part(Part::Moves);
barrier.wait();
part(Part::Arrivals);
barrier.wait();
