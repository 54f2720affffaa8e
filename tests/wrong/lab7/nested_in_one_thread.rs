// region: 7.9c
// fails: task_7_9_each_pair_comes_into_the_list_of_its_worker
// story: The inner loop has a team of one thread, which is what OpenMP does where nested parallelism is switched off. That is p1.
let count = team.count();
parallel_for(n, team, schedule, |worker, part| {
    for a in part {
        let first = a + 1;
        parallel_for(n - first, Team::Fresh(1), Schedule::Static, |member, part| {
            look(worker * count + member, a, first + part.start..first + part.end);
        });
    }
});
