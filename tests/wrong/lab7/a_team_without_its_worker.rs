// region: 7.9c
// fails: task_7_9_each_pair_comes_into_the_list_of_its_worker
// story: List number m is for member m of every team, so that members of different teams wait for each other.
let count = team.count();
parallel_for(n, team, schedule, |_, part| {
    for a in part {
        let first = a + 1;
        parallel_for(n - first, Team::Fresh(count), Schedule::Static, |member, part| {
            look(member, a, first + part.start..first + part.end);
        });
    }
});
