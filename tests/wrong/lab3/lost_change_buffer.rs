// region: 3.7
// fails: task_3_7_the_buffers_are_emptied_into_the_bins, task_3_7_fork_and_join
// story: The loop over threads stops one too early, and the last thread's leavers are lost.
let buffers: Vec<_> = buffers.collect();
let count = buffers.len();
for buffer in &buffers[..count.saturating_sub(1)] {
    for particle in *buffer {
        bins.put(*particle);
    }
}
