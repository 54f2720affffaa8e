// region: 11.4
// fails: task_11_4_two_may_be_off_their_paths
// story: Compared in single precision.
(2.0 * deviation) as f32 > margin as f32
