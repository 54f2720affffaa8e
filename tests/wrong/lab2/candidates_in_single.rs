// region: 2.9
// fails: task_2_9_the_order_of_memory_does_not_matter
// story: Candidates are chosen in single precision, so that one near the cutoff is left out.
self.found.clear();
for slice in candidates {
    observer.tested(slice.len() as u64);
    for neighbour in slice {
        let d = particle.to(neighbour);
        if (d.norm_squared() as f32) < (CUTOFF * CUTOFF) as f32 && neighbour.id != particle.id {
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
