// region: 4.1
// fails: task_4_1_every_bin_lies_in_a_region
// story: Bins counted in sixteen bits: of a large box the last ones lie in the first regions.
let (bin, each) = (bin as u16, self.bins_each as u16);
((bin / each.max(1)).into(), (bin % each.max(1)).into())
