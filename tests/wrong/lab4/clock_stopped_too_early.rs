// region: 4.2
// fails: task_4_2_all_waits_are_measured_and_a_free_lock_costs_no_clock
// story: The clock is read twice before the lock is there.
self.locks += 1;
if let Some(guard) = lock.try_lock() {
    return guard;
}
self.contended += 1;
let start = Instant::now();
self.waiting += start.elapsed();
lock.lock()
