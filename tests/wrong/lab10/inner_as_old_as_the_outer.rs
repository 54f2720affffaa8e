// region: 10.5b
// fails: task_10_5_the_inner_list_has_the_near_ones_in_order
// story: A new inner list is as old as the outer one: it is rebuilt more often than it must be.
let skin = self.inner_skin(self.bodies.fastest() * DT);
let reach = self.reach(skin);
let mut near = [[0; 2]; ROOM];
self.inner.pairs.clear();
for some in self.outer.pairs.chunks(ROOM) {
    let len = filter(some, self.bodies.positions(), reach * reach, &mut near);
    self.inner.pairs.extend_from_slice(&near[..len]);
}
(self.inner.skin, self.inner.displacement) = (skin, self.outer.displacement);
