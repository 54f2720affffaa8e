// region: 4.5
// fails: task_4_5_all_bins_are_filled_again, task_4_5_one_thread_rebuilds
// story: The bins still hold the particles of the step before.
for particle in particles {
    regions.bin_mut(grid.bin(particle)).push(particle.id);
}
