// region: 8.7b
// fails: task_8_7_the_bits_of_one_rank
// story: The master takes the candidates as they come in, worker after worker. What happens then depends on which worker found it, not on its time.
engine.taken.clear();
for candidate in &candidates {
    solution7::take(candidate, &mut free, &mut engine.taken);
}
for (disc, _) in engine.discs.iter_mut().zip(&free).filter(|(_, free)| **free) {
    disc.x += disc.vx;
    disc.y += disc.vy;
}
resolve(&engine.taken, &mut engine.discs, engine.square);
engine.tally.taken(&engine.taken);
