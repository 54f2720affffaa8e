// region: 9.2b
// fails: task_9_2_no_pair_is_lost_in_single_precision, task_9_3_the_list_grows_and_starts_again
// loses: 9.3
// story: Beyond the list's end nothing is written and nothing counted, so the host does not learn that candidates are missing.
    let index = atomicAdd(&count, 1u);
    if index < arrayLength(&candidates) {
        candidates[index] = vec2<u32>(a, b);
    } else {
        atomicSub(&count, 1u);
    }
