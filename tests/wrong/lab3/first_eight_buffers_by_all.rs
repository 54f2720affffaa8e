// region: 3.8
// fails: task_3_8_each_worker_takes_what_lies_in_its_rows, task_3_8_rebinning_by_all
// story: Room for eight threads: on more, their leavers are lost.
for particle in buffers.take(8).flatten() {
    let bin = grid.bin(particle).checked_sub(first_bin).and_then(|bin| own.get_mut(bin));
    if let Some(bin) = bin {
        bin.push(*particle);
    }
}
