// region: 3.3
// fails: task_3_3_every_row_has_one_owner_and_none_has_much_more
// story: Multiplies the worker by rows per worker as a float: 49 · (1 / 49) is less than 1, and the last row has no owner.
let each = rows as f64 / workers as f64;
(worker as f64 * each) as usize..((worker + 1) as f64 * each) as usize
