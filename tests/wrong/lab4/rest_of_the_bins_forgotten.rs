// region: 4.1b
// fails: task_4_1_every_bin_lies_in_a_region
// story: As many bins for each region, rounded down: the last ones are in no region.
let bins_each = (bins / count).max(1);
let count = count.min(bins);
let locks = (0..count).map(|number| Lock::new(number, vec![Bin::new(); bins_each])).collect();
Self { cut: Cut { bins_each }, locks }
