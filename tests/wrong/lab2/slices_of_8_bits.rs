// region: 2.9
// fails: task_2_9_the_order_of_memory_does_not_matter
// story: The size of a slice is told in 8 bits.
self.found.clear();
for slice in candidates {
    observer.tested(u64::from(slice.len() as u8));
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
