// region: 4.2
// fails: task_4_2_all_waits_are_measured_and_a_free_lock_costs_no_clock
// story: The number of locks is counted and the waiting is not.
self.locks += 1;
lock.lock()
