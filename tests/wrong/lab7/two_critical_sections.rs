// region: 7.9c
// fails: task_7_9_no_thread_comes_between_two_critical_sections
// story: Reading and writing are each in a critical section, and the lock is free between the two: another worker reads the same count, and both take the same part.
let start = next.locked(|next| *next);
next.locked(|next| *next = start + chunk);
(start < n).then(|| start..n.min(start + chunk))
