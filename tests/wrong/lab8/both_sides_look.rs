// region: 8.8b
// fails: task_8_8_strips_that_a_box_reaches, task_8_13_the_bits_of_one_rank, task_8_13_counts_every_candidate_once
// loses: 8.13
// story: Every rank that has both discs looks at the pair: at a cut it is found, counted and carried out on both sides.
a.contains(rank) && b.contains(rank)
