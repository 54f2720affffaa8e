// region: 8.12
// fails: task_8_12_each_disc_is_moved_once, task_8_13_the_bits_of_one_rank
// loses: 8.13
// story: A rank moves its own discs only. A ghost that has collided here is moved nowhere: its owner has been told that it was taken, and has forgotten it.
let taken: Vec<_> = decisions.taken.iter().map(|candidate| decisions.local(candidate)).collect();
for (slot, disc) in discs.iter_mut().enumerate() {
    if decisions.free[slot] && owns[slot] {
        disc.x += disc.vx;
        disc.y += disc.vy;
    }
}
resolve(&taken, discs, square);
let here = |slot: usize| decisions.taken.iter().any(|c| decisions.slots(c).any(|p| p == slot));
(0..discs.len())
    .filter(|&slot| owns[slot] && (decisions.free[slot] || here(slot)))
    .map(|slot| DiscWire::new(decisions.numbers[slot] as usize, &discs[slot]))
    .collect()
