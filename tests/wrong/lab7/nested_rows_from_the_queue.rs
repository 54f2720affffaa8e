// region: 7.9c
// fails: task_7_9_rows_come_from_the_queue_where_they_should
// story: The rows of the inner loop come by the schedule of the outer one, not in fixed parts.
let count = team.count();
parallel_for(n, team, schedule, |worker, part| {
    for a in part {
        let first = a + 1;
        parallel_for(n - first, Team::Fresh(count), schedule, |member, part| {
            look(worker * count + member, a, first + part.start..first + part.end);
        });
    }
});
