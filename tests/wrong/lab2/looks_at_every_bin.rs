// region: 2.4
// fails: task_2_4_rebuild_pair_tests_do_not_grow
// story: Right, and as slow as all-pairs: every bin is looked at.
let mut a = Vec2::ZERO;
for bin in &self.bins {
    observer.tested(bin.len() as u64);
    for neighbour in bin {
        add_pair(&mut a, particle.to(neighbour), observer);
    }
}
a
