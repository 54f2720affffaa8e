// region: 4.1
// fails: task_4_1_every_bin_lies_in_a_region
// loses: 4.3, 4.5, 4.6, 4.7, 4.8, 4.9
// story: Bins are dealt to the regions in turn, but each region holds bins that follow each other.
(bin % self.bins_each, bin / self.bins_each)
