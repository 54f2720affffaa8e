// region: 3.3
// fails: task_3_3_every_row_has_one_owner_and_none_has_much_more
// story: The product of rows and worker is computed in 32 bits.
let cut = |k: usize| ((k as u32).wrapping_mul(rows as u32) / workers as u32) as usize;
cut(worker)..cut(worker + 1)
