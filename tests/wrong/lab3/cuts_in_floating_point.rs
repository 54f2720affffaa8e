// region: 3.3
// fails: task_3_3_every_row_has_one_owner_and_none_has_much_more
// story: The cuts are computed in floating point and rounded down: of 10 workers with 90 rows one has 8 rows and another 10.
let cut = |k: usize| (k as f64 / workers as f64 * rows as f64) as usize;
cut(worker)..if worker + 1 == workers { rows } else { cut(worker + 1) }
