// region: 3.1
// fails: task_3_1_the_threads_of_the_pool_share_the_particles
// story: All threads merge what they have seen into one total behind a lock, as they come: its sum depends on their order.
let total = parking_lot::Mutex::new(O::default());
pool.install(|| {
    particles.par_iter().zip(&mut *accelerations).for_each(|(particle, a)| {
        let mut observer = O::default();
        *a = Vec2::ZERO;
        for neighbour in &*particles {
            add_pair(a, particle.to(neighbour), &mut observer);
        }
        observer.tested(particles.len() as u64);
        total.lock().merge(&observer);
    });
});
seen.fill(O::default());
seen[0] = total.into_inner();
