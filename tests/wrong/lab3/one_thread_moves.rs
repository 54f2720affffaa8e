// region: 3.6
// fails: task_3_6_the_threads_share_the_workers
// story: The forces are summed by all threads, and one of them moves all particles.
workers.par_iter_mut().for_each(|worker| worker.sum_forces(bins));
let own = own_bins(bins, workers);
workers.iter_mut().zip(own).for_each(|(worker, own)| worker.move_particles(&grid, own));
