// region: 7.9c
// fails: task_7_9_each_pair_comes_into_the_list_of_its_worker
// story: All members of a team append to the list of the worker that has started them. A lock keeps the list whole, and one thread at a time searches.
let count = team.count();
parallel_for(n, team, schedule, |worker, part| {
    for a in part {
        let first = a + 1;
        parallel_for(n - first, Team::Fresh(count), Schedule::Static, |_, part| {
            look(worker, a, first + part.start..first + part.end);
        });
    }
});
