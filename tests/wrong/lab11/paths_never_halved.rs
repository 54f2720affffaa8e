// region: 11.3
// fails: task_11_3_roots_of_chains_and_trees
// story: The root is found, but no path gets shorter: a chain of a thousand is walked a thousand times.
let mut k = k;
while parent[k as usize] != k {
    k = parent[k as usize];
}
k
