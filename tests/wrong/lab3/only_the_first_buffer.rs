// region: 3.6
// fails: task_3_6_everybody_takes_what_is_theirs, task_3_6_rebinning_by_all
// story: Each thread looks into one buffer only. Who came from another thread's rows is lost.
for particle in buffers.take(1).flatten() {
    let bin = grid.bin(particle).checked_sub(first_bin).and_then(|bin| own.get_mut(bin));
    if let Some(bin) = bin {
        bin.push(*particle);
    }
}
