// region: 1.1
// fails: task_1_1_bits_of_the_formula
// loses: 1.3
// story: The squares are compared in single precision: neighbours just beyond the cutoff are near.
let r2 = d.norm_squared();
if r2 as f32 > (CUTOFF * CUTOFF) as f32 {
    return None;
}
let r2 = r2.max(MIN_R * MIN_R);
let r = r2.sqrt();
let coef = (1.0 - CUTOFF / r) / r2 / MASS;
Some(coef * d)
