// region: 11.3
// fails: task_11_3_roots_of_chains_and_trees
// story: Numbers are followed in 16 bits.
let mut k = k;
while parent[k as usize] != k {
    parent[k as usize] = parent[parent[k as usize] as usize];
    k = parent[k as usize] & 0xffff;
}
k
