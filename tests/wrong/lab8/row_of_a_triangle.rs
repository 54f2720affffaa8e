// region: 8.3
// fails: task_8_3_a_job_is_all_pairs_of_its_blocks, task_8_7_the_bits_of_one_rank
// loses: 8.7
// story: Every job is treated as a triangle: disc k of the row meets only those of the column from number k + 1 on. The other half of each rectangle is never looked at.
let others = blocks.block(job.column);
let row = blocks.block(job.row);
let mut tests = 0;
for a in job.part.of(row.clone()) {
    let others = (others.start + a + 1 - row.start).min(others.end)..others.end;
    tests += others.len() as u64;
    look_along(discs, a, others, radius, list);
}
tests
