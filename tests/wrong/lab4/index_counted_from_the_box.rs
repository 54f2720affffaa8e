// region: 4.1
// fails: task_4_1_every_bin_lies_in_a_region, task_4_4_under_many_locks
// loses: 4.3, 4.5, 4.6, 4.7, 4.8, 4.9
// story: The right region, but the bin's index is counted from the start of the box instead of from that of the region.
(bin / self.bins_each, bin)
