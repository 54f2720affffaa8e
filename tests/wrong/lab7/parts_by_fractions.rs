// region: 7.8
// fails: task_7_8_fixed_parts_cover_the_loop
// story: Parts by a fraction in single precision.
let at = |k: usize| (n as f32 * (k as f32 / workers as f32)) as usize;
at(worker)..if worker + 1 == workers { n } else { at(worker + 1) }
