// region: 8.12
// fails: task_8_12_each_disc_is_moved_once
// loses: 8.13
// story: Discs that flew come first, then those that collided.
let taken: Vec<_> =
    decisions.taken.iter().map(|candidate| decisions.local(candidate)).collect();
let mut moved: Vec<bool> =
    decisions.free.iter().zip(owns).map(|(free, owns)| *free && *owns).collect();
for (disc, _) in discs.iter_mut().zip(&moved).filter(|(_, flies)| **flies) {
    disc.x += disc.vx;
    disc.y += disc.vy;
}
resolve(&taken, discs, square);
for slot in decisions.taken.iter().flat_map(|candidate| decisions.slots(candidate)) {
    moved[slot] = true;
}
let mut all: Vec<DiscWire> = Vec::new();
let numbered = decisions.numbers.iter().zip(&*discs).zip(&moved);
all.extend(numbered
    .filter(|(_, moved)| **moved)
    .map(|((number, disc), _)| DiscWire::new(*number as usize, disc)));
let hit = |wire: &DiscWire| decisions.slot(wire.number as u32).is_some_and(|slot| !decisions.free[slot]);
all.sort_by_key(hit);
all
