// region: 8.6b
// fails: task_8_6_workers_move_their_own_discs, task_8_7_the_bits_of_one_rank
// loses: 8.7
// story: The discs that arrive are put in first, and then all are moved: those that have collided fly a step too far.
for wire in arrived {
    discs[wire.index()] = wire.into();
}
for block in held.iter().filter(|_| moves) {
    for disc in &mut discs[block.clone()] {
        disc.x += disc.vx;
        disc.y += disc.vy;
    }
}
