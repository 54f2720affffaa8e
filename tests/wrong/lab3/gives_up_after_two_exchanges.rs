// region: 3.2b
// fails: task_3_2_another_thread_between_read_and_write
// story: The exchange is tried again when another thread came first, and given up when a third one did.
self.navg.fetch_add(part.navg);
self.pair_tests.fetch_add(part.pair_tests);
self.dmin.fetch_min(part.dmin.to_bits());
let sum = |bits: u64| (f64::from_bits(bits) + part.davg).to_bits();
let old = self.davg.load();
if let Err(now) = self.davg.compare_exchange(old, sum(old)) {
    let _ = self.davg.compare_exchange(now, sum(now));
}
