// region: 4.6
// fails: task_4_6_one_thread_empties_all_buffers
// story: An empty buffer is taken for the last one.
for change in buffers.take_while(|b| !b.is_empty()).flatten() {
    remove(regions.bin_mut(change.from), change.particle);
    regions.bin_mut(change.to).push(change.particle);
}
