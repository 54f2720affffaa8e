// region: 1.1
// fails: task_1_1_bits_of_the_formula
// story: A neighbour at exactly the cutoff is taken for one beyond it.
let r2 = d.norm_squared();
if r2 >= CUTOFF * CUTOFF {
    return None;
}
let r2 = r2.max(MIN_R * MIN_R);
let r = r2.sqrt();
let coef = (1.0 - CUTOFF / r) / r2 / MASS;
Some(coef * d)
