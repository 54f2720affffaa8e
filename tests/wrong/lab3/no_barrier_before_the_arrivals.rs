// region: 3.8
// fails: task_3_8_nobody_begins_a_part_too_early, task_3_8_a_late_member_changes_nothing
// story: Who has moved takes its mail at once, when not all letters are posted. They arrive a step late.
part(Part::Forces);
barrier.wait();
part(Part::Moves);
part(Part::Arrivals);
barrier.wait();
