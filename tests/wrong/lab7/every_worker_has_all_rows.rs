// region: 7.9
// fails: task_7_9_each_pair_comes_into_the_list_of_its_worker, task_7_9_the_programs_find_every_pair
// story: The part is not used: every worker goes through the whole outer loop, as a parallel region without a parallel loop does. All pairs are found as many times as there are workers.
parallel_for(n, team, schedule, |worker, _| {
    for a in 0..n {
        look(worker, a, a + 1..n);
    }
});
