// region: 3.2c
// fails: task_3_2_a_sum_that_repeats_its_last_digit
// story: Rayon's reduce adds up whatever is ready: right, and with other last digits on another number of threads.
let merge = |mut sum: O, part: O| {
    sum.merge(&part);
    sum
};
parts.par_iter().cloned().reduce(O::default, merge)
