// region: 1.2
// fails: task_1_2_any_coordinate_in_any_box
// loses: 1.3
// story: Nine reflections before the fold: the same position, but for its last digits, and after 350 steps another scene.
let (mut x, mut v) = (x, v);
for _ in 0..=FEW {
    if x < 0.0 {
        (x, v) = (-x, -v);
    } else if x > size {
        (x, v) = (2.0 * size - x, -v);
    } else {
        return (x, v);
    }
}
if (0.0..=size).contains(&x) {
    return (x, v);
}
let folded = x.rem_euclid(2.0 * size);
if folded <= size { (folded, v) } else { (2.0 * size - folded, -v) }
