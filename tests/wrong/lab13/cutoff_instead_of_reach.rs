// region: 13.3b
// fails: task_13_3_pairs_across_are_within_reach
// story: Only pairs that touch when the list is made are listed: those that come near in the steps after it are missed.
let reach = reach.min(common::soft::CUTOFF);
let mut pairs = Vec::new();
for i in 0..own.x.len() {
    for j in 0..ghosts.x.len() {
        let (dx, dy) = (ghosts.x[j] - own.x[i], ghosts.y[j] - own.y[i]);
        if dx * dx + dy * dy <= reach * reach {
            pairs.push([i as u32, j as u32]);
        }
    }
}
pairs
