// region: 8.8b
// fails: task_8_8_strips_that_a_box_reaches, task_8_13_the_bits_of_one_rank
// loses: 8.13
// story: The pair belongs to where its first disc's box begins. The other disc may not reach there, and then no rank looks.
a.first == rank && b.contains(rank)
