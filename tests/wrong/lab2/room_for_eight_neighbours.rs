// region: 2.9
// fails: task_2_9_sorted_crowds, task_2_9_sorted_steps, task_2_9_sorted_the_bits_of_all_pairs, task_2_9_the_order_of_memory_does_not_matter
// story: There is room for eight neighbours; the official scene never has more.
self.found.clear();
for slice in candidates {
    observer.tested(slice.len() as u64);
    for neighbour in slice {
        let d = particle.to(neighbour);
        if d.norm_squared() <= CUTOFF * CUTOFF && neighbour.id != particle.id && self.found.len() < 8 {
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
