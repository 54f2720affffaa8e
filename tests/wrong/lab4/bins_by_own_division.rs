// region: 4.5
// fails: task_4_5_all_bins_are_filled_again
// story: The bin by a division of its own and not by the grid: a particle exactly on the wall lies in none, or in the next row.
regions.parts_mut().flatten().for_each(Bin::clear);
let side = grid.bin_side();
for particle in particles {
    let (row, column) = ((particle.y / side) as usize, (particle.x / side) as usize);
    let bin = row * grid.columns() + column;
    if bin < grid.bins() {
        regions.bin_mut(bin).push(particle.id);
    }
}
