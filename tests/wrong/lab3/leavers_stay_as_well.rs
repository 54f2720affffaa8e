// region: 3.5
// fails: task_3_5_leavers_go_into_the_change_buffer, task_3_7_fork_and_join
// loses: 3.6
// story: What left is copied into the buffer and not taken out of the old bin: there are two now.
self.changed.clear();
for (particle, a) in own.iter_mut().flatten().zip(&self.accelerations) {
    advance(particle, *a, grid.size());
}
let first = self.rows.start * grid.columns();
for (bin, inside) in own.iter().enumerate() {
    self.changed.extend(inside.iter().filter(|p| grid.bin(p) != first + bin));
}
