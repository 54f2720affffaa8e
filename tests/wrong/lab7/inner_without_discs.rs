// region: 7.9b
// fails: task_7_9_each_pair_comes_into_the_list_of_its_worker
// story: Without discs the loop runs to 0 - 1.
for a in 0..n - 1 {
    let first = a + 1;
    parallel_for(n - first, team, schedule, |worker, part| {
        look(worker, a, first + part.start..first + part.end);
    });
}
