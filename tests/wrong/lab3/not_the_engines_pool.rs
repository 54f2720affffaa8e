// region: 3.1
// fails: task_3_1_the_threads_of_the_pool_share_the_particles
// story: The parallel loop runs outside of `install`, on as many threads as the machine has cores, whatever -t says.
let results = accelerations.par_iter_mut().zip(seen);
particles.par_iter().zip(results).for_each(|(particle, (a, observer))| {
    *a = Vec2::ZERO;
    *observer = O::default();
    for neighbour in &*particles {
        add_pair(a, particle.to(neighbour), observer);
    }
    observer.tested(particles.len() as u64);
});
let _ = pool;
