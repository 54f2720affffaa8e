// region: 1.1
// fails: task_1_1_table_of_forces, task_1_1_bits_of_the_formula, task_1_3_particles_at_one_position
// loses: 1.3
// story: Below MIN_R the vector itself is stretched to MIN_R, so the force stays at its largest value instead of falling to zero.
let r2 = d.norm_squared();
if r2 > CUTOFF * CUTOFF {
    return None;
}
let near = r2 < MIN_R * MIN_R && r2 > 0.0;
let d = if near { (MIN_R / r2.sqrt()) * d } else { d };
let r2 = r2.max(MIN_R * MIN_R);
let r = r2.sqrt();
let coef = (1.0 - CUTOFF / r) / r2 / MASS;
Some(coef * d)
