// region: 5.1b
// fails: task_5_1_blocks_are_cut_where_the_lab_says_and_owners_have_their_rows
// story: The quotient of ranks and rows as a floating-point number: times the last of 7 rows on 29 ranks it rounds to a little more than 29, and gives a rank that is not there.
((row + 1) as f64 * (self.ranks as f64 / self.rows as f64)).ceil() as usize - 1
