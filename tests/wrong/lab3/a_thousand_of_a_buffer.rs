// region: 3.8
// fails: task_3_8_each_worker_takes_what_lies_in_its_rows
// story: Of a buffer the first thousand are looked at.
for particle in buffers.flat_map(|b| b.iter().take(1000)) {
    let bin = grid.bin(particle).checked_sub(first_bin).and_then(|bin| own.get_mut(bin));
    if let Some(bin) = bin {
        bin.push(*particle);
    }
}
