// region: 3.1
// fails: task_3_1_every_pair_is_counted
// story: Each particle's observer is told of all pairs of all particles: n³ in all.
pool.install(|| {
    let results = accelerations.par_iter_mut().zip(seen);
    particles.par_iter().zip(results).for_each(|(particle, (a, observer))| {
        *a = Vec2::ZERO;
        *observer = O::default();
        for neighbour in &*particles {
            add_pair(a, particle.to(neighbour), observer);
        }
        observer.tested((particles.len() * particles.len()) as u64);
    });
});
