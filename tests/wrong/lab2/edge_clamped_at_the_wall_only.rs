// region: 2.1b
// fails: task_2_1_every_position_has_a_bin
// story: The far wall itself is taken care of, but just below it rounding gives the same product.
if x == self.size { self.along - 1 } else { (x * self.bins_per_length) as usize }
