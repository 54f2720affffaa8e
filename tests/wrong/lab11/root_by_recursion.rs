// region: 11.3
// fails: task_11_3_roots_of_chains_and_trees
// story: The root is found by a function that calls itself once for each parent: a chain of a million fills the stack.
fn above(parent: &mut [u32], k: u32) -> u32 {
    if parent[k as usize] != k {
        parent[k as usize] = above(parent, parent[k as usize]);
    }
    parent[k as usize]
}
above(parent, k)
