// region: 3.5
// fails: task_3_5_leavers_go_into_the_change_buffer
// loses: 3.6
// story: The accelerations are taken from the first one again in each bin.
self.changed.clear();
let first = self.rows.start * grid.columns();
for (bin, inside) in own.iter_mut().enumerate() {
    for (particle, a) in inside.iter_mut().zip(&self.accelerations) {
        advance(particle, *a, grid.size());
    }
    take_leavers(grid, first + bin, inside, &mut self.changed);
}
