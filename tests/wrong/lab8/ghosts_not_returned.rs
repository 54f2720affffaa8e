// region: 8.12
// fails: task_8_12_each_disc_is_moved_once, task_8_13_the_bits_of_one_rank
// loses: 8.13
// story: A rank moves its own discs only. A ghost that has collided here is moved nowhere: its owner has been told that it was taken, and has forgotten it.
let taken: Vec<_> = docket.taken.iter().map(|candidate| docket.local(candidate)).collect();
for (place, disc) in discs.iter_mut().enumerate() {
    if docket.free[place] && owns[place] {
        disc.x += disc.vx;
        disc.y += disc.vy;
    }
}
resolve(&taken, discs, square);
let here = |place: usize| docket.taken.iter().any(|c| docket.places(c).any(|p| p == place));
(0..discs.len())
    .filter(|&place| owns[place] && (docket.free[place] || here(place)))
    .map(|place| DiscWire::new(docket.numbers[place] as usize, &discs[place]))
    .collect()
