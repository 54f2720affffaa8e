// region: 3.7
// fails: task_3_7_the_buffers_are_emptied_into_the_bins, task_3_7_fork_and_join
// story: Room for eight threads: on more, their leavers are lost.
for particle in buffers.take(8).flatten() {
    bins.put(*particle);
}
