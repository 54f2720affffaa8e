// region: 4.3
// fails: task_4_3_the_wait_is_measured
// story: The number of locks is counted and the waiting is not.
self.locks += 1;
mutex.lock()
