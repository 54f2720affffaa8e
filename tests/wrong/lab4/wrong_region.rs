// region: 4.2
// fails: task_4_2_every_bin_lies_in_a_region
// loses: 4.4
// story: Bins are dealt to the regions in turn, but each region holds bins that follow each other. The lock that is taken guards other bins.
(&self.regions[bin % self.regions.len()], bin / self.regions.len())
