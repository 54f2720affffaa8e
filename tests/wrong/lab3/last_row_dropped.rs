// region: 3.3
// fails: task_3_3_every_row_has_one_owner_and_none_has_much_more
// story: Each thread has R / p rows, rounded down; what is left over belongs to none.
let each = rows / workers;
worker * each..(worker + 1) * each
