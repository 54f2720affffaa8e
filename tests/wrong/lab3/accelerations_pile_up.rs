// region: 3.1
// fails: task_3_1_all_pairs_on_several_threads
// story: The accelerations still hold the sums of the step before.
pool.install(|| {
    let results = accelerations.par_iter_mut().zip(seen);
    particles.par_iter().zip(results).for_each(|(particle, (a, observer))| {
        *observer = O::default();
        for neighbour in &*particles {
            add_pair(a, particle.to(neighbour), observer);
        }
        observer.tested(particles.len() as u64);
    });
});
