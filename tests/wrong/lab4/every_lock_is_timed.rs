// region: 4.2
// fails: task_4_2_all_waits_are_measured_and_a_free_lock_costs_no_clock
// story: The clock is read for every lock: what is measured is the clock.
self.locks += 1;
let start = Instant::now();
let guard = lock.lock();
self.waiting += start.elapsed();
guard
