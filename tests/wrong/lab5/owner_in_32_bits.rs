// region: 5.1b
// fails: task_5_1_blocks_are_cut_where_the_lab_says_and_owners_have_their_rows
// story: The product of rows and ranks in 32 bits: with 70,000 of both it does not fit.
let (row, ranks, rows) = (row as u32, self.ranks as u32, self.rows as u32);
((row + 1).wrapping_mul(ranks).wrapping_sub(1) / rows) as usize
