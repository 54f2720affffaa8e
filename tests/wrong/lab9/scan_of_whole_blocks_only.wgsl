// region: 9.6
// fails: task_9_6_prefix_sums_of_any_length
// loses: 9.7, 9.8
// story: The last block is written only if it is full: the tail of a partial workgroup keeps its counts.
    var mine = 0u;
    if i < arrayLength(&values) {
        mine = values[i];
    }
    partial[local] = mine;
    for (var reach = 1u; reach < THREADS; reach *= 2u) {
        workgroupBarrier();
        var sum = partial[local];
        if local >= reach {
            sum += partial[local - reach];
        }
        workgroupBarrier();
        partial[local] = sum;
    }
    if (block + 1u) * THREADS <= arrayLength(&values) {
        values[i] = partial[local] - mine;
    }
    if local == THREADS - 1u && block < arrayLength(&sums) {
        sums[block] = partial[local];
    }
