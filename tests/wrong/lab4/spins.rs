// region: 4.2
// fails: task_4_2_all_waits_are_measured_and_a_free_lock_costs_no_clock
// story: It tries again and again until the lock is free, and keeps a core busy with it.
self.locks += 1;
if let Some(guard) = lock.try_lock() {
    return guard;
}
self.contended += 1;
let start = Instant::now();
loop {
    if let Some(guard) = lock.try_lock() {
        self.waiting += start.elapsed();
        return guard;
    }
}
