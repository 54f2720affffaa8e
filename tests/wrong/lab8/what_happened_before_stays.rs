// region: 8.7b
// fails: task_8_7_only_what_collided_travels
// story: What was taken in the step before stays in the list.
let earlier = engine.taken.len();
take_in_order(&mut candidates, &mut free, &mut engine.taken);
for (disc, _) in engine.discs.iter_mut().zip(&free).filter(|(_, free)| **free) {
    disc.x += disc.vx;
    disc.y += disc.vy;
}
resolve(&engine.taken[earlier..], &mut engine.discs, engine.square);
engine.tally.taken(&engine.taken[earlier..]);
