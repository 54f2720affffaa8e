// region: 3.12
// fails: task_3_12_who_sees_the_flag_sees_the_numbers
// story: The flag is raised first, and the numbers come behind it.
let Statistics { dmin, davg, navg, pair_tests } = *statistics;
self.posted.store(1, Ordering::Release);
self.dmin.store(dmin.to_bits(), Ordering::Relaxed);
self.davg.store(davg.to_bits(), Ordering::Relaxed);
self.navg.store(navg, Ordering::Relaxed);
self.pair_tests.store(pair_tests, Ordering::Relaxed);
