// region: 3.8
// fails: task_3_8_each_worker_takes_what_lies_in_its_rows
// story: The bin by a division of its own and not by the grid: a particle exactly on the wall lies in none, and is lost.
let side = grid.bin_side();
for particle in buffers.flatten() {
    let (row, column) = ((particle.y / side) as usize, (particle.x / side) as usize);
    if column >= grid.columns() {
        continue;
    }
    let bin = (row * grid.columns() + column).checked_sub(first_bin).and_then(|bin| own.get_mut(bin));
    if let Some(bin) = bin {
        bin.push(*particle);
    }
}
