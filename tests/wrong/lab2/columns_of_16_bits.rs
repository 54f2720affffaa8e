// region: 2.1b
// fails: task_2_1_every_position_has_a_bin
// story: A column has room for 16 bits: in a long row bin 65,536 is bin 0.
((x * self.bins_per_length) as u16 as usize).min(self.along - 1)
