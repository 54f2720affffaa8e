// region: 10.5
// fails: task_10_5_skins_for_how_far_the_fastest_goes_in_a_step
// loses: 10.6
// story: The skin is for a speed, where a distance in a step is asked for: the list expires at once.
let skin = self.skin(self.bodies.fastest());
let reach = self.reach(skin);
let grid = Grid::new(&Extent::of(&self.bodies), reach);
let cells = self.sorter.sort(&mut self.bodies, grid, &Workers::default());
let (positions, pairs) = (self.bodies.positions(), &mut self.outer.pairs);
let mut len = 0;
for i in 0..positions.x.len() {
    for range in cells.ahead(i) {
        make_room(pairs, len + range.len() + EIGHT);
        len = collect(pairs, len, positions, i, range, reach, signs);
    }
}
pairs.truncate(len);
(self.outer.skin, self.outer.displacement) = (skin, 0.0);
self.inner.displacement = f64::INFINITY;
