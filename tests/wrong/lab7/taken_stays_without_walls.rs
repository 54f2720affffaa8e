// region: 7.7
// fails: task_7_7_a_step_begins_with_nothing_taken
// story: Where no disc reaches a wall, what happened in the step before is carried out again.
let windows = self.finder.windows(&self.discs, self.square);
self.free.fill(true);
self.find_walls(windows);
if !self.walls.is_empty() {
    self.taken.clear();
}
let mut next_wall = 0;
for k in 0..windows {
    next_wall = self.collide_in(Window::part(k, windows), next_wall);
}
self.move_discs();
