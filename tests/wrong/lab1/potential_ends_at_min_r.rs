// region: 1.5
// fails: task_1_5_the_potential_of_a_pair
// story: Below MIN_R the potential stays flat, though the force goes on pushing.
let r = d.norm_squared().sqrt();
if r > CUTOFF {
    return 0.0;
}
let ratio = CUTOFF / r.max(MIN_R);
ratio - 1.0 - ratio.ln()
