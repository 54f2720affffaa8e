// region: 3.5
// fails: task_3_5_leavers_go_into_the_change_buffer
// story: A worker whose bins are empty keeps its buffer, whose particles then arrive twice.
if own.iter().all(Vec::is_empty) {
    return;
}
self.changed.clear();
let first = self.rows.start * grid.columns();
let mut accelerations = self.accelerations.iter();
for (bin, inside) in own.iter_mut().enumerate() {
    for (particle, a) in inside.iter_mut().zip(&mut accelerations) {
        advance(particle, *a, grid.size());
    }
    take_leavers(grid, first + bin, inside, &mut self.changed);
}
