// region: 7.8
// fails: task_7_8_fixed_parts_cover_the_loop
// story: Parts are computed in 32 bits.
let at = |k: usize| ((k as u32).wrapping_mul(n as u32) / workers as u32) as usize;
at(worker)..at(worker + 1)
