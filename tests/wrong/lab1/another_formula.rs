// region: 1.1
// fails: task_1_1_bits_of_the_formula, task_1_3_bits_of_dense_boxes
// loses: 1.3
// story: The same formula on paper, with other last digits.
let r2 = d.norm_squared();
if r2 > CUTOFF * CUTOFF {
    return None;
}
let r2 = r2.max(MIN_R * MIN_R);
let r = r2.sqrt();
let coef = (r - CUTOFF) / (r * r2 * MASS);
Some(coef * d)
