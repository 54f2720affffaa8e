// region: 3.2c
// fails: task_3_2_a_sum_that_repeats_its_last_digit
// story: Blocks behind the 256th are not added.
let sum = |parts: &[O]| {
    let mut sum = O::default();
    parts.iter().for_each(|part| sum.merge(part));
    sum
};
let blocks: Vec<O> = parts.par_chunks(BLOCK).take(256).map(sum).collect();
sum(&blocks)
