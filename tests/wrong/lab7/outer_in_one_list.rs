// region: 7.9
// fails: task_7_9_each_pair_comes_into_the_list_of_its_worker
// story: Only the first eight workers have lists of their own.
parallel_for(n, team, schedule, |worker, part| {
    for a in part {
        look(worker % 8, a, a + 1..n);
    }
});
