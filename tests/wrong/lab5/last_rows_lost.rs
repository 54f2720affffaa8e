// region: 5.1
// fails: task_5_1_blocks_are_cut_where_the_lab_says_and_owners_have_their_rows, task_5_8_the_bits_of_all_pairs_in_a_dense_box
// story: Each rank gets rows / ranks rows, so that the last ones belong to no rank when the division leaves a remainder, and no rank has any when ranks outnumber rows.
let each = self.rows / self.ranks;
rank * each..(rank + 1) * each
