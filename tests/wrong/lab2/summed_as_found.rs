// region: 2.9
// fails: task_2_9_sorted_the_bits_of_all_pairs, task_2_9_sorted_the_bits_of_other_official_scenes, task_2_9_the_order_of_memory_does_not_matter
// story: Neighbours are summed in the order of memory: right but for the last digits.
self.found.clear();
for slice in candidates {
    observer.tested(slice.len() as u64);
    for neighbour in slice {
        let d = particle.to(neighbour);
        if d.norm_squared() <= CUTOFF * CUTOFF && neighbour.id != particle.id {
            self.found.push((neighbour.id, d));
        }
    }
}
let mut a = Vec2::ZERO;
for (_, d) in &self.found {
    add_pair(&mut a, *d, observer);
}
a
