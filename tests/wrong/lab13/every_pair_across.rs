// region: 13.3b
// fails: task_13_3_pairs_across_are_within_reach
// story: Every particle is compared with every ghost, near or far along x.
let mut pairs = Vec::new();
for (i, (x, y)) in (0..).zip(own.x.iter().zip(own.y)) {
    for (ghost, (ghost_x, ghost_y)) in (0..).zip(ghosts.x.iter().zip(ghosts.y)) {
        let (dx, dy) = (ghost_x - x, ghost_y - y);
        if dx * dx + dy * dy <= reach * reach {
            pairs.push([i, ghost]);
        }
    }
}
pairs
