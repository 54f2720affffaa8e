// region: 3.6
// fails: task_3_6_every_worker_sums_and_moves
// story: The particles of the first 64 workers move.
workers.par_iter_mut().for_each(|worker| worker.sum_forces(bins));
let own = own_bins(bins, workers);
workers
    .par_iter_mut()
    .zip(own)
    .take(64)
    .for_each(|(worker, own)| worker.move_particles(&grid, own));
