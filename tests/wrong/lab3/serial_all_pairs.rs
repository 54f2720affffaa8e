// region: 3.1
// fails: task_3_1_the_threads_of_the_pool_share_the_particles
// story: The loop is run inside the pool, by one of its threads. The answer is right and the second core asleep.
pool.install(|| {
    let results = accelerations.iter_mut().zip(seen);
    particles.iter().zip(results).for_each(|(particle, (a, observer))| {
        *a = Vec2::ZERO;
        *observer = O::default();
        for neighbour in &*particles {
            add_pair(a, particle.to(neighbour), observer);
        }
        observer.tested(particles.len() as u64);
    });
});
