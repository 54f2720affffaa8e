// region: 11.4
// fails: task_11_4_two_may_be_off_their_paths
// story: A little more than the margin is let through.
2.0 * deviation > margin * (1.0 + 1e-9)
