// region: 4.2
// fails: task_4_2_all_waits_are_measured_and_a_free_lock_costs_no_clock
// story: Each wait replaces the one before: what is told is the last one, not the sum.
self.locks += 1;
if let Some(guard) = lock.try_lock() {
    return guard;
}
self.contended += 1;
let start = Instant::now();
let guard = lock.lock();
self.waiting = start.elapsed();
guard
