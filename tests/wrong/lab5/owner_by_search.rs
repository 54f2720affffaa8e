// region: 5.1b
// fails: task_5_1_blocks_are_cut_where_the_lab_says_and_owners_have_their_rows
// story: It looks for the block that has the row, rank after rank: the root would do that for every particle.
(0..self.ranks).find(|&rank| self.block(rank).contains(&row)).expect("a rank has it")
