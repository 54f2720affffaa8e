// region: 7.9c
// fails: task_7_9_rows_come_from_the_queue_where_they_should
// story: The team that has the rows shares each of them too: no thread is started, and each waits for the others.
let count = team.count();
parallel_for(n, team, schedule, |worker, part| {
    for a in part {
        let first = a + 1;
        parallel_for(n - first, team, Schedule::Static, |member, part| {
            look(worker * count + member, a, first + part.start..first + part.end);
        });
    }
});
