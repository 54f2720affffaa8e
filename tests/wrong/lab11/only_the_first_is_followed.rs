// region: 11.3b
// fails: task_11_3_two_groups_become_one
// story: Only the root of a is searched.
let (a, b) = (root(parent, a), parent[b as usize]);
parent[a.max(b) as usize] = a.min(b);
