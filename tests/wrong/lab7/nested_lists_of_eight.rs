// region: 7.9c
// fails: task_7_9_each_pair_comes_into_the_list_of_its_worker
// story: Lists are numbered for teams of eight.
let count = team.count();
parallel_for(n, team, schedule, |worker, part| {
    for a in part {
        let first = a + 1;
        parallel_for(n - first, Team::Fresh(count), Schedule::Static, |member, part| {
            look(worker * count + member % 8, a, first + part.start..first + part.end);
        });
    }
});
