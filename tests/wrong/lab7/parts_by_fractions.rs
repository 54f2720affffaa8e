// region: 7.8
// fails: task_7_8_fixed_parts_cover_the_loop
// story: The edges are fractions times n: 1/49 of 49 rounds to 0, and the next part has two.
let edge = |worker: usize| (worker as f64 / workers as f64 * n as f64) as usize;
edge(worker)..edge(worker + 1)
