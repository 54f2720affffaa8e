// region: 1.1
// fails: task_1_1_table_of_forces, task_1_1_the_neighbour_pushes_away_along_the_line_between, task_1_3_steps_of_a_dense_box
// loses: 1.3
// story: The sign is turned round: neighbours attract.
let r2 = d.norm_squared();
if r2 > CUTOFF * CUTOFF {
    return None;
}
let r2 = r2.max(MIN_R * MIN_R);
let r = r2.sqrt();
let coef = (CUTOFF / r - 1.0) / r2 / MASS;
Some(coef * d)
