// region: 5.9
// fails: task_5_9_statistics_of_all_ranks
// story: The least distances of all ranks are added up like everything else.
let counts = [own.navg, own.pair_tests];
let distances = [own.dmin, own.davg];
let mut all = Statistics::default();
let (mut sums, mut lengths) = ([0; 2], [0.0; 2]);
if world.rank() != ROOT {
    root.reduce_into(&distances[..], SystemOperation::sum());
    root.reduce_into(&counts[..], SystemOperation::sum());
    return None;
}
root.reduce_into_root(&distances[..], &mut lengths[..], SystemOperation::sum());
root.reduce_into_root(&counts[..], &mut sums[..], SystemOperation::sum());
[all.navg, all.pair_tests] = sums;
[all.dmin, all.davg] = lengths;
let _ = SystemOperation::min();
Some(all)
