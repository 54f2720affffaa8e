// region: 3.7
// fails: task_3_7_the_buffers_are_emptied_into_the_bins
// story: The number of the buffer in eight bits: of more than 256 threads the last ones' particles are lost.
for (_, buffer) in (0..=u8::MAX).zip(buffers) {
    for particle in buffer {
        bins.put(*particle);
    }
}
