// region: 11.4
// fails: task_11_4_two_may_be_off_their_paths
// story: At the margin exactly it is too far.
2.0 * deviation >= margin
