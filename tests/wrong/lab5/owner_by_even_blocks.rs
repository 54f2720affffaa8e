// region: 5.1b
// fails: task_5_1_the_owner_of_a_row_has_it_in_its_block
// story: The owner is computed as if all blocks had the same number of rows, rounded up.
row / self.rows.div_ceil(self.ranks)
