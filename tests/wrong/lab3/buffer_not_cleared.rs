// region: 3.5
// fails: task_3_5_leavers_go_into_the_change_buffer, task_3_7_fork_and_join, task_3_8_rebinning_by_all
// story: What left in the step before is still in the buffer, and arrives a second time.
for (particle, a) in own.iter_mut().flatten().zip(&self.accelerations) {
    advance(particle, *a, grid.size());
}
let first = self.rows.start * grid.columns();
for (bin, inside) in own.iter_mut().enumerate() {
    take_leavers(grid, first + bin, inside, &mut self.changed);
}
