// region: 9.5b
// fails: task_9_5_takes_what_the_sort_takes, task_9_5_chosen_has_the_bytes_of_the_sequential_program
// story: The ranks of later candidates count too: the first of a disc has the time of one and the rank of another, no candidate is both, and rounds would go on for ever.
    atomicMin(&firsts[disc].rank, rank(other));
