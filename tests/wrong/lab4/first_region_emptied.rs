// region: 4.5
// fails: task_4_5_all_bins_are_filled_again
// story: Only the bins of the first region are emptied.
regions.parts_mut().take(1).flatten().for_each(Bin::clear);
for particle in particles {
    regions.bin_mut(grid.bin(particle)).push(particle.id);
}
