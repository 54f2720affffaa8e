// region: 9.1b
// fails: task_9_1_launches_within_the_limits
// story: The sum of n and the workgroup's threads may not fit 32 bits: n = 2^32 − 1 in groups of 64 asks for one workgroup.
if threads == 0 {
    return Self::launch(1, threads, limits);
}
Self::launch((n.wrapping_add(threads - 1) / threads).max(1), threads, limits)
