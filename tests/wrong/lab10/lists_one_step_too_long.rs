// region: 10.6b
// fails: task_10_6_two_meet_after_half_a_skin_each
// story: The outer list is looked at when the step is over, before the step's displacement is added: it is used one step too long.
if self.outer.displacement.is_infinite() {
    self.rebuild(signs);
}
if expired(self.inner.displacement, self.inner.skin) {
    self.rebuild_inner();
}
self.accelerate();
self.bodies.moving().advance::<Tasks>(&self.ax, &self.ay, DT, self.size);
let farthest = self.bodies.fastest() * DT + self.rounding();
self.inner.displacement += farthest;
if expired(self.outer.displacement, self.outer.skin) {
    self.rebuild(signs);
}
self.outer.displacement += farthest;
