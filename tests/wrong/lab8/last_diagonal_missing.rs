// region: 8.2
// fails: task_8_2_a_job_on_each_diagonal, task_8_7_the_bits_of_one_rank
// loses: 8.7
// story: The diagonals are counted up to, without, W / 2: the blocks opposite each other on the ring never meet, and no worker looks at their pairs.
let Deal { workers, offsets } = deal;
let job = |d: usize| {
    let there = |p: &&usize| offsets.contains(&((**p + d) % workers));
    let p = offsets.iter().find(there).expect("the offsets cover every distance");
    let (i, j) = ((worker + p) % workers, (worker + p + d) % workers);
    Job { row: i.min(j), column: i.max(j), part: Part::Whole }
};
(0..workers.div_ceil(2)).map(job).collect()
