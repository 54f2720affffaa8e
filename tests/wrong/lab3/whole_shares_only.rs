// region: 3.1
// fails: task_3_1_every_pair_is_counted
// story: Each thread gets the same number of particles; those that are left over are forgotten.
pool.install(|| {
    let share = (particles.len() / rayon::current_num_threads()).max(1);
    let results =
        accelerations.par_chunks_exact_mut(share).zip(seen.par_chunks_exact_mut(share));
    particles.par_chunks_exact(share).zip(results).for_each(|(own, (a, seen))| {
        for ((particle, a), observer) in own.iter().zip(a).zip(seen) {
            *a = Vec2::ZERO;
            *observer = O::default();
            for neighbour in &*particles {
                add_pair(a, particle.to(neighbour), observer);
            }
            observer.tested(particles.len() as u64);
        }
    });
});
