// region: 7.10
// fails: task_7_10_no_thread_comes_between_two_critical_sections
// story: The candidate is written inside the critical section: all others wait for a write that nobody else can touch.
count.locked(|count| {
    list.put(*count, candidate);
    *count += 1;
});
