// region: 2.9
// fails: task_2_9_sorted_memory_does_not_grow
// story: The list of neighbours is leaked, so that it can be lent without an end: its memory never comes back.
let mut found = Vec::new();
for slice in candidates {
    observer.tested(slice.len() as u64);
    for neighbour in slice {
        let d = particle.to(neighbour);
        if d.norm_squared() <= CUTOFF * CUTOFF && neighbour.id != particle.id {
            found.push((neighbour.id, d));
        }
    }
}
let found: &'static mut [(u32, Vec2)] = found.leak();
found.sort_unstable_by_key(|(id, _)| *id);
let mut a = Vec2::ZERO;
for (_, d) in found {
    add_pair(&mut a, *d, observer);
}
a
