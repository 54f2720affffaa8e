// region: 2.5
// fails: task_2_5_incremental_keeps_every_particle_for_1000_steps, task_2_5_incremental_steps, task_2_5_incremental_the_official_run, task_2_5_incremental_statistics
// story: Only the column is compared: a particle that leaves upwards or downwards is not noticed.
let mut i = 0;
while i < inside.len() {
    if grid.column(inside[i].x) == bin % grid.columns() {
        i += 1;
    } else {
        changed.push(inside.swap_remove(i));
    }
}
