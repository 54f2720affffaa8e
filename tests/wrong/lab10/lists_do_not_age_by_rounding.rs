// region: 10.6b
// fails: task_10_6_a_step_makes_both_lists_older
// story: Lists do not age by rounding.
if expired(self.outer.displacement, self.outer.skin) {
    self.rebuild(signs);
}
if expired(self.inner.displacement, self.inner.skin) {
    self.rebuild_inner();
}
self.accelerate();
self.bodies.moving().advance::<Tasks>(&self.ax, &self.ay, DT, self.size);
let farthest = self.bodies.fastest() * DT;
self.outer.displacement += farthest;
self.inner.displacement += farthest;
