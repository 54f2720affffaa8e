// region: 11.3b
// fails: task_11_3_pairs_join_their_groups, task_11_5_windows_have_the_bits_of_all_pairs
// story: The two of a pair are joined, not their roots: a particle with two pairs leaves its first group.
let (low, high) = (a.min(b), a.max(b));
parent[high as usize] = low;
