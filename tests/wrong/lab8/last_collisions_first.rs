// region: 8.7b
// fails: task_8_7_the_bits_of_one_rank
// story: The list of what happened is not cleared: from the second step on old collisions are carried out again.
take_in_order(&mut candidates, &mut free, &mut engine.taken);
for (disc, _) in engine.discs.iter_mut().zip(&free).filter(|(_, free)| **free) {
    disc.x += disc.vx;
    disc.y += disc.vy;
}
resolve(&engine.taken, &mut engine.discs, engine.square);
engine.tally.taken(&engine.taken);
