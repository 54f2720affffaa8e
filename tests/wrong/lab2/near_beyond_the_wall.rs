// region: 2.2
// fails: task_2_2_bins_next_to_a_bin
// loses: 2.4, 2.7
// story: At the far wall the range goes on to a bin that does not exist.
index.saturating_sub(1)..index + 2
