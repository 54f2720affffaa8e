// region: 3.2b
// fails: task_3_2_another_thread_between_read_and_write
// story: After a hundred exchanges in vain the sum is given up.
self.navg.fetch_add(part.navg);
self.pair_tests.fetch_add(part.pair_tests);
self.dmin.fetch_min(part.dmin.to_bits());
let mut old = self.davg.load();
for _ in 0..100 {
    let new = (f64::from_bits(old) + part.davg).to_bits();
    match self.davg.compare_exchange(old, new) {
        Ok(_) => break,
        Err(now) => old = now,
    }
}
