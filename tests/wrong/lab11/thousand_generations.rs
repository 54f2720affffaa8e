// region: 11.3
// fails: task_11_3_roots_of_chains_and_trees
// story: Follows a thousand parents at most.
let mut k = k;
for _ in 0..1000 {
    parent[k as usize] = parent[parent[k as usize] as usize];
    k = parent[k as usize];
}
k
