// region: 2.5
// fails: task_2_5_incremental_crowds, task_2_5_incremental_keeps_every_particle_for_1000_steps, task_2_5_incremental_steps, task_2_5_incremental_the_official_run
// story: A leaver is copied and not taken out: it is then in two bins.
for particle in inside.iter() {
    if grid.bin(particle) != bin {
        changed.push(*particle);
    }
}
