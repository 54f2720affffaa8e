// region: 11.3
// fails: task_11_3_the_root_of_a_chain, task_11_3_pairs_join_their_groups
// story: The parent is taken for the root: a group longer than two falls apart.
parent[k as usize]
