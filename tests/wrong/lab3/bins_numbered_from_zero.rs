// region: 3.5
// fails: task_3_5_leavers_go_into_the_change_buffer
// story: The own bins are numbered from 0 instead of from the first own row: all seem to have left. The run is right and does all the work twice.
self.changed.clear();
for (particle, a) in own.iter_mut().flatten().zip(&self.accelerations) {
    advance(particle, *a, grid.size());
}
for (bin, inside) in own.iter_mut().enumerate() {
    take_leavers(grid, bin, inside, &mut self.changed);
}
