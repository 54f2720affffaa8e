// region: 2.2
// fails: task_2_2_bins_next_to_a_bin
// story: The end of the range is computed in 16 bits.
index.saturating_sub(1)..usize::from((index as u16).saturating_add(2)).min(self.along)
