// region: 1.1
// fails: task_1_1_table_of_forces, task_1_1_bits_of_the_formula, task_1_3_pairs_at_the_cutoff
// loses: 1.3
// story: The cutoff is 0.1 % too small. The force there is nearly zero, so the official run hardly shows it.
let cutoff = 0.999 * CUTOFF;
let r2 = d.norm_squared();
if r2 > cutoff * cutoff {
    return None;
}
let r2 = r2.max(MIN_R * MIN_R);
let r = r2.sqrt();
let coef = (1.0 - CUTOFF / r) / r2 / MASS;
Some(coef * d)
