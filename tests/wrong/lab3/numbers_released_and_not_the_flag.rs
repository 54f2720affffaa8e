// region: 3.12
// fails: task_3_12_who_sees_the_flag_sees_the_numbers
// story: The numbers are written with release and the flag without: a thread that sees the flag takes nothing over.
let Statistics { dmin, davg, navg, pair_tests } = *statistics;
self.dmin.store(dmin.to_bits(), Ordering::Release);
self.davg.store(davg.to_bits(), Ordering::Release);
self.navg.store(navg, Ordering::Release);
self.pair_tests.store(pair_tests, Ordering::Release);
self.posted.store(1, Ordering::Relaxed);
