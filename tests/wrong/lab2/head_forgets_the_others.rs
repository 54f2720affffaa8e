// region: 2.6
// fails: task_2_6_lists_hold_what_was_inserted, task_2_6_the_last_in_is_the_first_out
// loses: 2.7
// story: The new head does not point to the old one: every list has one particle.
self.next[particle] = NONE;
self.heads[bin] = particle as u32;
