// region: 11.4
// fails: task_11_4_two_may_be_off_their_paths
// story: The difference to the margin must be more than 1e-12.
2.0 * deviation - margin > 1e-12
