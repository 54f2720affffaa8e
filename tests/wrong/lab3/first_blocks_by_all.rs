// region: 3.2c
// fails: task_3_2_the_threads_share_the_parts
// story: Blocks in a fixed order: one for each thread, and all others by the thread that adds up.
let sum = |parts: &[O]| {
    let mut sum = O::default();
    parts.iter().for_each(|part| sum.merge(part));
    sum
};
let few = (BLOCK * rayon::current_num_threads()).min(parts.len());
let mut blocks: Vec<O> = parts[..few].par_chunks(BLOCK).map(sum).collect();
blocks.extend(parts[few..].chunks(BLOCK).map(sum));
sum(&blocks)
