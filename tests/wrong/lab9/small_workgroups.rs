// region: 9.1b
// fails: task_9_1_launches_within_the_limits
// story: Few items get a smaller workgroup than was asked for.
if threads == 0 {
    return Self::launch(1, threads, limits);
}
let threads = threads.min(n.max(1));
Self::launch(n.div_ceil(threads).max(1), threads, limits)
