// region: 5.1
// fails: task_5_1_blocks_are_cut_where_the_lab_says_and_owners_have_their_rows
// story: The course report's cut: rows / ranks rows each and the rest for the last rank. With more ranks than rows the last has them all.
let each = self.rows / self.ranks;
let end = if rank + 1 == self.ranks { self.rows } else { (rank + 1) * each };
rank * each..end
