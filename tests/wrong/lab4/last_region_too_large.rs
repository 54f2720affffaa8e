// region: 4.1b
// fails: task_4_1_every_bin_lies_in_a_region
// story: All regions have the same number of bins, so the last one has bins that do not exist.
let bins_each = bins.div_ceil(count);
let regions = bins.div_ceil(bins_each);
let locks = (0..regions).map(|number| Lock::new(number, vec![Bin::new(); bins_each])).collect();
Self { cut: Cut { bins_each }, locks }
