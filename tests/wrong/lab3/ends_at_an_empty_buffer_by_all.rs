// region: 3.8
// fails: task_3_8_each_worker_takes_what_lies_in_its_rows
// story: An empty buffer is taken for the last one.
for particle in buffers.take_while(|buffer| !buffer.is_empty()).flatten() {
    let bin = grid.bin(particle).checked_sub(first_bin).and_then(|bin| own.get_mut(bin));
    if let Some(bin) = bin {
        bin.push(*particle);
    }
}
