// region: 3.8
// fails: task_3_8_each_worker_takes_what_lies_in_its_rows
// story: Numbers of bins are compared in 16 bits.
for particle in buffers.flatten() {
    let bin = (grid.bin(particle) as u16 as usize)
        .checked_sub(first_bin as u16 as usize)
        .and_then(|bin| own.get_mut(bin));
    if let Some(bin) = bin {
        bin.push(*particle);
    }
}
