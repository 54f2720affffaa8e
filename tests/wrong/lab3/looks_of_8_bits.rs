// region: 3.1
// fails: task_3_1_every_pair_is_counted
// story: The number of particles is told in 8 bits.
pool.install(|| {
    let results = accelerations.par_iter_mut().zip(seen);
    particles.par_iter().zip(results).for_each(|(particle, (a, observer))| {
        *a = Vec2::ZERO;
        *observer = O::default();
        for neighbour in &*particles {
            add_pair(a, particle.to(neighbour), observer);
        }
        observer.tested(u64::from(particles.len() as u8));
    });
});
