// region: 7.10
// fails: task_7_10_a_steal_that_met_another_thread_is_tried_again
// story: A steal that met another thread counts as a deque without parts. The worker finds nothing this time and comes back later, so that nothing is lost but time: on most days no test would notice.
own.pop().or_else(|| others.iter().find_map(|other| other.steal().success()))
