// region: 7.7b
// fails: task_7_7_a_step_in_three_windows
// story: The next wall is counted from the first of this window. In a step of one window nobody asks.
self.found.clear(1);
self.finder.find(&self.discs, &self.free, self.square, window, &mut self.found);
let later = self.walls[next_wall..].partition_point(|wall| wall.time < window.to);
self.found.lists[0].extend_from_slice(&self.walls[next_wall..next_wall + later]);
self.choice.take(&self.workers, &mut self.found, &mut self.free, &mut self.taken);
later
