// region: 10.5b
// fails: task_10_5_skins_for_how_far_the_fastest_goes_in_a_step
// loses: 10.6
// story: The inner skin is for a speed, where a distance in a step is asked for.
let skin = self.inner_skin(self.bodies.fastest());
let reach = self.reach(skin);
let mut near = [[0; 2]; ROOM];
self.inner.pairs.clear();
for some in self.outer.pairs.chunks(ROOM) {
    let len = filter(some, self.bodies.positions(), reach * reach, &mut near);
    self.inner.pairs.extend_from_slice(&near[..len]);
}
(self.inner.skin, self.inner.displacement) = (skin, 0.0);
