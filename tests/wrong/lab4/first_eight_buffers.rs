// region: 4.6
// fails: task_4_6_one_thread_empties_all_buffers, task_4_6_buffers_emptied_by_one
// story: Room for eight threads: on more, their changes are lost.
for change in buffers.take(8).flatten() {
    remove(regions.bin_mut(change.from), change.particle);
    regions.bin_mut(change.to).push(change.particle);
}
