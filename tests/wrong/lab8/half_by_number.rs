// region: 8.2
// fails: task_8_2_a_job_on_each_diagonal
// story: Which half of an opposite pair a worker does follows from its own number, not from where its blocks lie: where p is not 0, a half is done twice.
let job = |d: usize| {
    let there = |p: &&usize| offsets.contains(&((**p + d) % workers));
    let p = offsets.iter().find(there).expect("the offsets cover every distance");
    let (i, j) = ((worker + p) % workers, (worker + p + d) % workers);
    let part = match (2 * d == *workers, worker < workers / 2) {
        (false, _) => Part::Whole,
        (true, true) => Part::First,
        (true, false) => Part::Second,
    };
    Job { row: i.min(j), column: i.max(j), part }
};
(0..=workers / 2).map(job).collect()
