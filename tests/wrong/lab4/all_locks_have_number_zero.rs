// region: 4.1b
// fails: task_4_1_lock_r_guards_region_r
// story: The locks are made and none has a number, so that no order can be told of them.
let bins_each = bins.div_ceil(count);
let region = |number: usize| {
    Lock::new(0, vec![Bin::new(); bins_each.min(bins - number * bins_each)])
};
let locks = (0..bins.div_ceil(bins_each)).map(region).collect();
Self { cut: Cut { bins_each }, locks }
