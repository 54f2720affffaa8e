// region: 2.1b
// fails: task_2_1_every_position_has_a_bin
// story: A particle on the far wall gets a bin beyond the last.
(x * self.bins_per_length) as usize
