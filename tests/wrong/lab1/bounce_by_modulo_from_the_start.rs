// region: 1.2
// fails: task_1_2_bounces_once
// loses: 1.3
// story: Folding with one period instead of two: the particle comes in again at the other wall.
let folded = x.rem_euclid(size);
if (0.0..=size).contains(&x) { (x, v) } else { (folded, -v) }
