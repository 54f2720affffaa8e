// region: 11.3b
// fails: task_11_3_two_groups_become_one
// story: Each number has its root as its parent, and at each pair all numbers are gone through for the greater root: right, and as slow as if every particle met every other.
let (a, b) = (root(parent, a), root(parent, b));
for parent in parent.iter_mut().filter(|parent| **parent == a.max(b)) {
    *parent = a.min(b);
}
