// region: 7.9
// fails: task_7_9_the_outer_loop_is_dealt_out_in_whole_rows, task_7_9_the_programs_find_every_pair
// story: The part is not used: every worker goes through the whole outer loop, as a parallel region without a parallel loop does. All pairs are found as many times as there are workers.
parallel_for(n, team, schedule, |worker, _| {
    for a in 0..n {
        look(worker, a, a + 1..n);
    }
});
