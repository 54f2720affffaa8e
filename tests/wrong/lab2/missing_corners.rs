// region: 2.4
// fails: task_2_4_a_neighbour_is_felt_from_every_bin_around, task_2_4_each_particle_of_nine_bins_once, task_2_4_rebuild_crowds, task_2_4_rebuild_pairs_over_every_edge
// story: The four corner bins are forgotten, so a pair that meets diagonally is missed.
let mut a = Vec2::ZERO;
let (own_row, own_column) = (self.grid.row(particle.y), self.grid.column(particle.x));
for row in self.grid.near(own_row) {
    for column in self.grid.near(own_column) {
        if row != own_row && column != own_column {
            continue;
        }
        let bin = &self.bins[row * self.grid.columns() + column];
        observer.tested(bin.len() as u64);
        for neighbour in bin {
            add_pair(&mut a, particle.to(neighbour), observer);
        }
    }
}
a
