// region: 5.9
// fails: task_5_9_statistics_of_all_ranks
// story: All ranks collect the numbers of all and add them up, and only the root's are used.
let ranks = world.size() as usize;
let mut sums = vec![0; 2 * ranks];
let (mut dmin, mut davg) = (vec![0.0; ranks], vec![0.0; ranks]);
world.all_gather_into(&own.dmin, &mut dmin[..]);
world.all_gather_into(&own.davg, &mut davg[..]);
world.all_gather_into(&[own.navg, own.pair_tests][..], &mut sums[..]);
let all = Statistics {
    dmin: dmin.into_iter().fold(f64::INFINITY, f64::min),
    davg: davg.into_iter().sum(),
    navg: sums.iter().step_by(2).sum(),
    pair_tests: sums.iter().skip(1).step_by(2).sum(),
};
(world.rank() == ROOT).then_some(all)
