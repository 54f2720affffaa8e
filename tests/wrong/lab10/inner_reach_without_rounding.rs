// region: 10.5b
// fails: task_10_5_rounding_hides_no_pair
// story: The inner list looks as far as cutoff and skin to the last digit.
let skin = self.inner_skin(self.bodies.fastest() * DT);
let reach = CUTOFF + skin;
let mut near = [[0; 2]; ROOM];
self.inner.pairs.clear();
for some in self.outer.pairs.chunks(ROOM) {
    let len = filter(some, self.bodies.positions(), reach * reach, &mut near);
    self.inner.pairs.extend_from_slice(&near[..len]);
}
(self.inner.skin, self.inner.displacement) = (skin, 0.0);
