// region: 8.3
// fails: task_8_3_a_job_is_all_pairs_of_its_blocks
// loses: 8.7
// story: What is in the list already is forgotten.
list.clear();
let column = blocks.block(job.column);
let mut tests = 0_u64;
for a in job.part.of(blocks.block(job.row)) {
    let partners = column.start.max(a + 1)..column.end;
    tests += partners.len() as u64;
    look_along(discs, a, partners, radius, list);
}
tests
