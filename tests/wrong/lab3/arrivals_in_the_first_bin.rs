// region: 3.8
// fails: task_3_8_each_worker_takes_what_lies_in_its_rows, task_3_8_rebinning_by_all
// story: The right thread takes the particle, and puts it into the first bin of its row.
let columns = grid.columns();
for particle in buffers.flatten() {
    let bin = grid.bin(particle).checked_sub(first_bin).filter(|bin| *bin < own.len());
    if let Some(bin) = bin {
        own[bin / columns * columns].push(*particle);
    }
}
