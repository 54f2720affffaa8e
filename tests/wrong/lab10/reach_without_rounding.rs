// region: 10.5
// fails: task_10_5_rounding_hides_no_pair
// story: The list looks as far as cutoff and skin to the last digit: a pair that rounding put a hair further is not listed.
let skin = self.skin(self.bodies.fastest() * DT);
let reach = CUTOFF + skin;
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
