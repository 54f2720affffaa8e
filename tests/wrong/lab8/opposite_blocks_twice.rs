// region: 8.2
// fails: task_8_2_a_job_on_each_diagonal, task_8_7_counts_every_pair_once
// story: With an even number of workers the pairs of opposite blocks are dealt to both: every collision among them is found twice. The results are right all the same, since a disc is taken once; only the counts tell.
let Deal { workers, offsets } = deal;
let job = |d: usize| {
    let there = |p: &&usize| offsets.contains(&((**p + d) % workers));
    let p = offsets.iter().find(there).expect("the offsets cover every distance");
    let (i, j) = ((worker + p) % workers, (worker + p + d) % workers);
    Job { row: i.min(j), column: i.max(j), part: Part::Whole }
};
(0..=workers / 2).map(job).collect()
