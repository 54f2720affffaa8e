// region: 2.4
// fails: task_2_4_a_neighbour_is_felt_from_every_bin_around, task_2_4_each_particle_of_nine_bins_once, task_2_4_rebuild_boxes_of_one_particle_and_a_wide_one, task_2_4_rebuild_crowds
// story: The own bin is summed first, and then once more as one of the nine.
let mut a = Vec2::ZERO;
for neighbour in &self.bins[self.grid.bin(particle)] {
    add_pair(&mut a, particle.to(neighbour), observer);
}
for row in self.grid.near(self.grid.row(particle.y)) {
    for column in self.grid.near(self.grid.column(particle.x)) {
        let bin = &self.bins[row * self.grid.columns() + column];
        observer.tested(bin.len() as u64);
        for neighbour in bin {
            add_pair(&mut a, particle.to(neighbour), observer);
        }
    }
}
a
