// region: 3.2b
// fails: task_3_2_another_thread_between_read_and_write
// story: The exchange fails because another thread came first, and is not tried again.
self.navg.fetch_add(part.navg);
self.pair_tests.fetch_add(part.pair_tests);
self.dmin.fetch_min(part.dmin.to_bits());
let old = self.davg.load();
let new = (f64::from_bits(old) + part.davg).to_bits();
let _ = self.davg.compare_exchange(old, new);
