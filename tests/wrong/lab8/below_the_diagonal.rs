// region: 8.2
// fails: task_8_2_a_job_on_each_diagonal, task_8_7_the_bits_of_one_rank
// loses: 8.7
// story: Where a diagonal goes on from the other side of the matrix, row and column are not swapped: block pair (4, 0) is dealt instead of (0, 4), and its lower numbers are looked for in the higher block.
let Deal { workers, offsets } = deal;
let job = |d: usize| {
    let there = |p: &&usize| offsets.contains(&((**p + d) % workers));
    let p = offsets.iter().find(there).expect("the offsets cover every distance");
    let (i, j) = ((worker + p) % workers, (worker + p + d) % workers);
    let part = match (2 * d == *workers, i < j) {
        (false, _) => Part::Whole,
        (true, true) => Part::First,
        (true, false) => Part::Second,
    };
    Job { row: i, column: j, part }
};
(0..=workers / 2).map(job).collect()
