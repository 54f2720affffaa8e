// region: 8.12
// fails: task_8_12_each_disc_is_moved_once, task_8_13_the_bits_of_one_rank
// loses: 8.13
// story: A rank keeps all its own discs. One that was taken on the other side of the cut is then there twice: as it was, and as it came back.
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
    .filter(|&place| owns[place] || here(place))
    .map(|place| DiscWire::new(docket.numbers[place] as usize, &discs[place]))
    .collect()
