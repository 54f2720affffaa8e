// region: 3.1
// fails: task_3_1_the_threads_of_the_pool_share_the_particles
// story: Each thread gets one particle, and the rest is left to the one that has started the loop.
let all = &*particles;
let sum = |((particle, a), observer): ((&Particle, &mut Vec2), &mut O)| {
    *a = Vec2::ZERO;
    *observer = O::default();
    for neighbour in all {
        add_pair(a, particle.to(neighbour), observer);
    }
    observer.tested(all.len() as u64);
};
let few = pool.current_num_threads().min(all.len());
let ((first, rest), (a, other_a)) = (all.split_at(few), accelerations.split_at_mut(few));
let (own, other) = seen.split_at_mut(few);
pool.install(|| {
    first.par_iter().zip(a).zip(own).for_each(sum);
    rest.iter().zip(other_a).zip(other).for_each(sum);
});
