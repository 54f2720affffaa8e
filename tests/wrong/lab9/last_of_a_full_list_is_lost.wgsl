// region: 9.2b
// fails: task_9_2_no_pair_is_lost_in_single_precision
// story: The last candidate of a list that is exactly full is counted but not written.
    let index = atomicAdd(&count, 1u);
    if index + 1u < arrayLength(&candidates) {
        candidates[index] = vec2<u32>(a, b);
    }
