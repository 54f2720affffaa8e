// region: 3.12
// fails: task_3_12_who_sees_the_flag_sees_the_numbers
// story: The flag is raised with a relaxed store, which hands nothing on: a thread may see it before the numbers.
let Statistics { dmin, davg, navg, pair_tests } = *statistics;
self.dmin.store(dmin.to_bits(), Ordering::Relaxed);
self.davg.store(davg.to_bits(), Ordering::Relaxed);
self.navg.store(navg, Ordering::Relaxed);
self.pair_tests.store(pair_tests, Ordering::Relaxed);
self.posted.store(1, Ordering::Relaxed);
