// region: 7.9b
// fails: task_7_9_each_pair_comes_into_the_list_of_its_worker, task_7_9_the_programs_find_every_pair
// story: A part of the inner loop is counted from disc 0, and not from disc a + 1.
for a in 0..n {
    parallel_for(n - a - 1, team, schedule, |worker, part| look(worker, a, part));
}
