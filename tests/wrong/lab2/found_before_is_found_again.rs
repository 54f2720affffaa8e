// region: 2.9
// fails: task_2_9_the_order_of_memory_does_not_matter, task_2_9_every_sum_starts_from_nothing, task_2_9_sorted_boxes_of_one_particle_and_a_wide_one, task_2_9_sorted_crowds
// story: The neighbours of the particle before are still in the list.
for slice in candidates {
    observer.tested(slice.len() as u64);
    for neighbour in slice {
        let d = particle.to(neighbour);
        if d.norm_squared() <= CUTOFF * CUTOFF && neighbour.id != particle.id {
            self.found.push((neighbour.id, d));
        }
    }
}
self.found.sort_unstable_by_key(|(id, _)| *id);
let mut a = Vec2::ZERO;
for (_, d) in &self.found {
    add_pair(&mut a, *d, observer);
}
a
