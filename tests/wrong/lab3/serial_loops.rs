// region: 3.6
// fails: task_3_6_the_threads_share_the_workers
// story: The workers have their turns one after the other, all on one thread.
workers.iter_mut().for_each(|worker| worker.sum_forces(bins));
let own = own_bins(bins, workers);
workers.iter_mut().zip(own).for_each(|(worker, own)| worker.move_particles(&grid, own));
