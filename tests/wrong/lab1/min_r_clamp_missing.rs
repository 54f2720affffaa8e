// region: 1.1
// fails: task_1_1_table_of_forces, task_1_1_bits_of_the_formula, task_1_3_particles_at_one_position
// loses: 1.3
// story: The force keeps growing below MIN_R, and at distance zero it is no number.
let r2 = d.norm_squared();
if r2 > CUTOFF * CUTOFF {
    return None;
}
let r = r2.sqrt();
let coef = (1.0 - CUTOFF / r) / r2 / MASS;
Some(coef * d)
