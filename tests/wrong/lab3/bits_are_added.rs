// region: 3.2b
// fails: task_3_2_a_sum_with_atomics
// story: The bits of two floating-point numbers are added as if they were whole numbers.
self.navg.fetch_add(part.navg);
self.pair_tests.fetch_add(part.pair_tests);
self.dmin.fetch_min(part.dmin.to_bits());
self.davg.fetch_add(part.davg.to_bits());
