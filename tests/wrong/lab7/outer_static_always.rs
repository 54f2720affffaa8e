// region: 7.9
// fails: task_7_9_rows_come_from_the_queue_where_they_should
// story: The schedule is ignored.
let _ = schedule;
parallel_for(n, team, Schedule::Static, |worker, part| {
    for a in part {
        look(worker, a, a + 1..n);
    }
});
