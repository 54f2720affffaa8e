// region: 3.2b
// fails: task_3_2_another_thread_between_read_and_write
// story: The sum is loaded, added to and stored. Each of the two is atomic, and both together are not.
self.navg.fetch_add(part.navg);
self.pair_tests.fetch_add(part.pair_tests);
self.dmin.fetch_min(part.dmin.to_bits());
let sum = f64::from_bits(self.davg.load()) + part.davg;
self.davg.store(sum.to_bits());
