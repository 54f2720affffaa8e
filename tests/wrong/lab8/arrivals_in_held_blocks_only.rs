// region: 8.6b
// fails: task_8_6_workers_move_their_own_discs
// story: Discs that arrive for blocks that are not held are dropped.
for block in held.iter().filter(|_| moves) {
    for disc in &mut discs[block.clone()] {
        disc.x += disc.vx;
        disc.y += disc.vy;
    }
}
for wire in arrived.iter().filter(|wire| held.iter().any(|block| block.contains(&wire.index()))) {
    discs[wire.index()] = wire.into();
}
