// region: 5.9
// fails: task_5_9_statistics_of_all_ranks
// story: The counts are reduced as numbers of 32 bits: those of a long run or of many ranks do not fit.
let counts = [own.navg as u32, own.pair_tests as u32];
if world.rank() != ROOT {
    root.reduce_into(&own.dmin, SystemOperation::min());
    root.reduce_into(&own.davg, SystemOperation::sum());
    root.reduce_into(&counts[..], SystemOperation::sum());
    return None;
}
let mut all = Statistics::default();
let mut sums = [0_u32; 2];
root.reduce_into_root(&own.dmin, &mut all.dmin, SystemOperation::min());
root.reduce_into_root(&own.davg, &mut all.davg, SystemOperation::sum());
root.reduce_into_root(&counts[..], &mut sums[..], SystemOperation::sum());
[all.navg, all.pair_tests] = sums.map(u64::from);
Some(all)
