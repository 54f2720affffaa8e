// region: 2.5
// fails: task_2_5_incremental_keeps_every_particle_for_1000_steps, task_2_5_incremental_steps, task_2_5_leavers_are_taken_out_and_the_rest_stay, task_2_5_incremental_statistics
// story: The particle swapped into the gap is not looked at: it stays in the wrong bin until the next step.
let mut i = 0;
while i < inside.len() {
    if grid.bin(&inside[i]) != bin {
        changed.push(inside.swap_remove(i));
    }
    i += 1;
}
