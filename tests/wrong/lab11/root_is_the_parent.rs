// region: 11.3
// fails: task_11_3_roots_of_chains_and_trees, task_11_3_pairs_join_their_groups
// story: The parent is taken for the root: a group longer than two falls apart.
parent[k as usize]
