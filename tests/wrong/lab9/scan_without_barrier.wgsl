// region: 9.6
// fails: task_9_6_prefix_sums_of_any_length
// loses: 9.7, 9.8
// story: No barriers: an invocation that is ahead adds numbers that its neighbours have not written yet, or have overwritten already.
    var mine = 0u;
    if i < arrayLength(&values) {
        mine = values[i];
    }
    partial[local] = mine;
    for (var reach = 1u; reach < THREADS; reach *= 2u) {
        var sum = partial[local];
        if local >= reach {
            sum += partial[local - reach];
        }
        partial[local] = sum;
    }
    if i < arrayLength(&values) {
        values[i] = partial[local] - mine;
    }
    if local == THREADS - 1u && block < arrayLength(&sums) {
        sums[block] = partial[local];
    }
