// region: 1.2
// fails: task_1_2_bounces_once, task_1_3_steps_of_a_dense_box
// loses: 1.3
// story: The position is reflected and the velocity is not, so the particle runs into the wall again and again.
let mut x = x;
for _ in 0..FEW {
    if x < 0.0 {
        x = -x;
    } else if x > size {
        x = 2.0 * size - x;
    } else {
        return (x, v);
    }
}
let folded = x.rem_euclid(2.0 * size);
(if folded <= size { folded } else { 2.0 * size - folded }, v)
