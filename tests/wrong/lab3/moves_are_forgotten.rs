// region: 3.6
// fails: task_3_6_every_worker_sums_and_moves
// story: All forces are summed, and only the first worker's particles move.
workers.par_iter_mut().for_each(|worker| worker.sum_forces(bins));
let own = own_bins(bins, workers);
workers
    .par_iter_mut()
    .zip(own)
    .take(1)
    .for_each(|(worker, own)| worker.move_particles(&grid, own));
