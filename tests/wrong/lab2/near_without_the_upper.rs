// region: 2.2
// fails: task_2_2_bins_next_to_a_bin
// loses: 2.4, 2.7
// story: The end of a range is not in it: the column to the right and the row above are never looked at.
index.saturating_sub(1)..(index + 1).min(self.along)
