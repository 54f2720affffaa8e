// region: 3.2c
// fails: task_3_2_the_threads_share_the_parts
// story: Blocks in a fixed order, all summed by one thread.
let sum = |parts: &[O]| {
    let mut sum = O::default();
    parts.iter().for_each(|part| sum.merge(part));
    sum
};
let blocks: Vec<O> = parts.chunks(BLOCK).map(sum).collect();
sum(&blocks)
