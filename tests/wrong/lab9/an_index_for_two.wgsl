// region: 9.2b
// fails: task_9_2_no_pair_is_lost_in_single_precision
// loses: 9.3, 9.4
// story: The index is read and then written, in two pieces: invocations that come together get the same index.
    let index = atomicLoad(&count);
    atomicStore(&count, index + 1u);
    if index < arrayLength(&candidates) {
        candidates[index] = vec2<u32>(a, b);
    }
