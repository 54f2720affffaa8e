// region: 8.7b
// fails: task_8_7_only_what_collided_travels
// story: A step without candidates moves all discs and leaves what the step before took: the workers are told of it again and again.
if candidates.is_empty() {
    for disc in &mut engine.discs {
        disc.x += disc.vx;
        disc.y += disc.vy;
    }
    return;
}
engine.taken.clear();
take_in_order(&mut candidates, &mut free, &mut engine.taken);
for (disc, _) in engine.discs.iter_mut().zip(&free).filter(|(_, free)| **free) {
    disc.x += disc.vx;
    disc.y += disc.vy;
}
resolve(&engine.taken, &mut engine.discs, engine.square);
engine.tally.taken(&engine.taken);
