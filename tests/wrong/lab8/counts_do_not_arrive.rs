// region: 8.6b
// fails: task_8_6_workers_move_their_own_discs
// story: What arrives is position and velocity; counts stay.
for block in held.iter().filter(|_| moves) {
    for disc in &mut discs[block.clone()] {
        disc.x += disc.vx;
        disc.y += disc.vy;
    }
}
for wire in arrived {
    let disc = &mut discs[wire.index()];
    (disc.x, disc.y, disc.vx, disc.vy) = (wire.x, wire.y, wire.vx, wire.vy);
}
