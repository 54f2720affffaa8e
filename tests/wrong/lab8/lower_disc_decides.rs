// region: 8.8b
// fails: task_8_8_one_rank_looks_at_a_pair, task_8_13_the_bits_of_one_rank
// loses: 8.13
// story: The pair belongs to where its first disc's box begins. The other disc may not reach there, and then no rank looks.
a.first == rank && b.contains(rank)
