// region: 2.9
// fails: task_2_9_the_order_of_memory_does_not_matter
// story: Only candidates in reach are counted, and the particle itself: bins of any size seem to do the same work.
self.found.clear();
let mut count = 1;
for neighbour in candidates.into_iter().flatten() {
    let d = particle.to(neighbour);
    if d.norm_squared() <= CUTOFF * CUTOFF && neighbour.id != particle.id {
        self.found.push((neighbour.id, d));
        count += 1;
    }
}
observer.tested(count);
self.found.sort_unstable_by_key(|(id, _)| *id);
let mut a = Vec2::ZERO;
for (_, d) in &self.found {
    add_pair(&mut a, *d, observer);
}
a
