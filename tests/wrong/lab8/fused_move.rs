// region: 8.6b
// fails: task_8_6_workers_move_their_own_discs
// loses: 8.7
// story: Moves with a fused multiply and add of 1: no other digits. Positions in single.
for block in held.iter().filter(|_| moves) {
    for disc in &mut discs[block.clone()] {
        disc.x = f64::from((disc.x + disc.vx) as f32);
        disc.y += disc.vy;
    }
}
for wire in arrived {
    discs[wire.index()] = wire.into();
}
