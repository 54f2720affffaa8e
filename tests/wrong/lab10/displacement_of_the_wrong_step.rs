// region: 10.6b
// fails: task_10_6_a_step_makes_both_lists_older
// story: How far a particle goes is taken before the step changes its velocity.
if expired(self.outer.displacement, self.outer.skin) {
    self.rebuild(signs);
}
if expired(self.inner.displacement, self.inner.skin) {
    self.rebuild_inner();
}
let farthest = self.bodies.fastest() * DT + self.rounding();
self.accelerate();
self.bodies.moving().advance::<Tasks>(&self.ax, &self.ay, DT, self.size);
self.outer.displacement += farthest;
self.inner.displacement += farthest;
