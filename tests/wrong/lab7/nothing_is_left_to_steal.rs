// region: 7.10b
// fails: task_7_10_halves_lie_ready_the_largest_at_the_bottom, task_7_10_what_a_busy_worker_left_is_stolen
// story: A worker begins its whole part at once: nothing lies in its deque, and the others go idle as with fixed parts.
part
