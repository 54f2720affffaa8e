// region: 3.7
// fails: task_3_7_the_buffers_are_emptied_into_the_bins
// story: An empty buffer is taken for the last one.
for particle in buffers.take_while(|buffer| !buffer.is_empty()).flatten() {
    bins.put(*particle);
}
