// region: 3.3
// fails: task_3_3_every_row_has_one_owner_and_none_has_much_more
// story: Rows are cut in single precision.
let cut = |k: usize| (k as f32 * rows as f32 / workers as f32) as usize;
cut(worker)..cut(worker + 1)
