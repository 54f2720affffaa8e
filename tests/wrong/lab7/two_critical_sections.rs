// region: 7.10
// fails: task_7_10_no_thread_comes_between_two_critical_sections
// story: Reading and writing are each in a critical section, and the lock is free between the two: another worker reads the same count, and both write into the same slot. A candidate is lost.
let slot = count.locked(|count| *count);
count.locked(|count| *count = slot + 1);
list.put(slot, candidate);
