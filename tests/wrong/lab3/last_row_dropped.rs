// region: 3.2
// fails: task_3_2_every_row_has_one_owner, task_3_2_table_of_cuts
// story: Everybody has R / p rows, rounded down; what is left over belongs to nobody.
let each = rows / workers;
worker * each..(worker + 1) * each
