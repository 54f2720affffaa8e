// region: 4.2
// fails: task_4_2_every_bin_lies_in_a_region, task_4_4_under_many_locks
// loses: 4.4
// story: The right lock, but the bin's place is counted from the start of the box instead of from that of the region.
(&self.regions[bin / self.bins_each], bin)
