// region: 8.6b
// fails: task_8_6_workers_move_their_own_discs, task_8_7_blocks_again_in_every_step
// loses: 8.7
// story: Discs are moved in every step, also where they have just arrived as they are: `moves` is not looked at.
for wire in arrived {
    discs[wire.index()] = wire.into();
}
for block in held {
    for number in block.clone() {
        if !moves || arrived.iter().all(|wire| wire.index() != number) {
            let disc = &mut discs[number];
            disc.x += disc.vx;
            disc.y += disc.vy;
        }
    }
}
