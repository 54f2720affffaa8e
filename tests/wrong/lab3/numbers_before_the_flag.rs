// region: 3.12b
// fails: task_3_12_who_sees_the_flag_sees_the_numbers
// story: The numbers are read first, and then the flag: it may be raised in between.
let numbers = Statistics {
    dmin: f64::from_bits(self.dmin.load(Ordering::Relaxed)),
    davg: f64::from_bits(self.davg.load(Ordering::Relaxed)),
    navg: self.navg.load(Ordering::Relaxed),
    pair_tests: self.pair_tests.load(Ordering::Relaxed),
};
(self.posted.load(Ordering::Acquire) == 1).then_some(numbers)
