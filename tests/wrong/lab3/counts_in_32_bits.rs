// region: 3.2b
// fails: task_3_2_a_sum_with_atomics
// story: Counts go through 32 bits.
self.navg.fetch_add(u64::from(part.navg as u32));
self.pair_tests.fetch_add(u64::from(part.pair_tests as u32));
self.dmin.fetch_min(part.dmin.to_bits());
let mut old = self.davg.load();
loop {
    let new = (f64::from_bits(old) + part.davg).to_bits();
    match self.davg.compare_exchange(old, new) {
        Ok(_) => break,
        Err(now) => old = now,
    }
}
