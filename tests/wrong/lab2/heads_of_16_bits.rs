// region: 2.6
// fails: task_2_6_lists_hold_what_was_inserted
// story: A head has room for 16 bits: in a large box a list begins with another particle.
self.next[particle] = self.heads[bin];
self.heads[bin] = u32::from(particle as u16);
