// region: 2.4
// fails: task_2_4_a_neighbour_is_felt_from_every_bin_around, task_2_4_each_particle_of_nine_bins_once, task_2_4_rebuild_crowds, task_2_4_rebuild_pairs_over_every_edge
// story: The column to the left is never looked at.
let mut a = Vec2::ZERO;
let own_column = self.grid.column(particle.x);
for row in self.grid.near(self.grid.row(particle.y)) {
    for column in own_column..self.grid.near(own_column).end {
        let bin = &self.bins[row * self.grid.columns() + column];
        observer.tested(bin.len() as u64);
        for neighbour in bin {
            add_pair(&mut a, particle.to(neighbour), observer);
        }
    }
}
a
