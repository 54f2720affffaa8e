// region: 2.6
// fails: task_2_6_lists_hold_what_was_inserted
// loses: 2.7
// story: The new head does not point to the old one: every list has one particle.
self.next[particle] = NONE;
self.heads[bin] = particle as u32;
