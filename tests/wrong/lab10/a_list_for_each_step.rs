// region: 10.6b
// fails: task_10_6_a_list_lasts
// story: Both lists are built in each step: right, and as slow as without a list.
self.rebuild(signs);
self.rebuild_inner();
self.accelerate();
self.bodies.moving().advance::<Tasks>(&self.ax, &self.ay, DT, self.size);
let farthest = self.bodies.fastest() * DT + self.rounding();
self.outer.displacement += farthest;
self.inner.displacement += farthest;
