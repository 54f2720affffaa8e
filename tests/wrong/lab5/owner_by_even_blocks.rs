// region: 5.1b
// fails: task_5_1_blocks_are_cut_where_the_lab_says_and_owners_have_their_rows
// story: The owner is computed as if all blocks had the same number of rows, rounded up.
row / self.rows.div_ceil(self.ranks)
