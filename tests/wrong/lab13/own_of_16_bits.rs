// region: 13.3b
// fails: task_13_3_pairs_across_are_within_reach
// story: Own indices in 16 bits.
let mut order: Vec<u32> = (0..ghosts.x.len() as u32).collect();
let along = |ghost: u32| ghosts.x[ghost as usize];
order.sort_unstable_by(|a, b| along(*a).total_cmp(&along(*b)).then(a.cmp(b)));
let mut pairs = Vec::new();
for (i, (x, y)) in (0..).zip(own.x.iter().zip(own.y)) {
    let first = order.partition_point(|ghost| along(*ghost) < x - reach);
    for &ghost in order[first..].iter().take_while(|ghost| along(**ghost) <= x + reach) {
        let (dx, dy) = (along(ghost) - x, ghosts.y[ghost as usize] - y);
        if dx * dx + dy * dy <= reach * reach {
            pairs.push([i & 0xffff, ghost]);
        }
    }
}
pairs
