// region: 1.2
// fails: task_1_2_any_coordinate_in_any_box
// story: The sign is looked at, not the order: x = -0.0 is on the wall and is reflected.
let (mut x, mut v) = (x, v);
for _ in 0..FEW {
    if x.is_sign_negative() {
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
