// region: 3.2c
// fails: task_3_2_a_sum_that_repeats_its_last_digit
// story: The sums of the blocks are added to the total in the order in which threads finish, here the last first.
let total = Mutex::new(O::default());
let mut blocks: Vec<_> = parts.chunks(BLOCK).collect();
blocks.reverse();
blocks.into_iter().for_each(|block| {
    let mut sum = O::default();
    block.iter().for_each(|part| sum.merge(part));
    total.lock().merge(&sum);
});
total.into_inner()
