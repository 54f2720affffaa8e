// region: 8.8
// fails: task_8_8_strips_that_a_box_reaches, task_8_13_the_bits_of_one_rank
// loses: 8.9, 8.13
// story: Only the position at the start of the step counts, as for soft discs: a disc that flies into another strip is not seen there.
Reach { first: strips.rank_of(disc.y - reach), last: strips.rank_of(disc.y + reach) }
