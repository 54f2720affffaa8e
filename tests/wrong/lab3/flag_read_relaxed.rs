// region: 3.12b
// fails: task_3_12_who_sees_the_flag_sees_the_numbers
// story: The flag is looked at with a relaxed load, which takes nothing over.
(self.posted.load(Ordering::Relaxed) == 1).then(|| Statistics {
    dmin: f64::from_bits(self.dmin.load(Ordering::Relaxed)),
    davg: f64::from_bits(self.davg.load(Ordering::Relaxed)),
    navg: self.navg.load(Ordering::Relaxed),
    pair_tests: self.pair_tests.load(Ordering::Relaxed),
})
