// region: 7.7
// fails: task_7_7_a_step_begins_with_nothing_taken
// story: A disc alone keeps what happened in the step before: its bounce is carried out again.
let windows = self.finder.windows(&self.discs, self.square);
self.free.fill(true);
if self.discs.len() > 1 {
    self.taken.clear();
}
self.find_walls(windows);
let mut next_wall = 0;
for k in 0..windows {
    next_wall = self.collide_in(Window::part(k, windows), next_wall);
}
self.move_discs();
