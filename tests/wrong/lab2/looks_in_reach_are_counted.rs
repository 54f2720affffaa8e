// region: 2.4
// fails: task_2_4_each_particle_of_nine_bins_once
// story: Only pairs in reach are counted as looked at: bins of any size seem to do the same work.
let mut a = Vec2::ZERO;
for row in self.grid.near(self.grid.row(particle.y)) {
    for column in self.grid.near(self.grid.column(particle.x)) {
        for neighbour in &self.bins[row * self.grid.columns() + column] {
            let d = particle.to(neighbour);
            if d.norm_squared() <= common::soft::CUTOFF * common::soft::CUTOFF {
                observer.tested(1);
                add_pair(&mut a, d, observer);
            }
        }
    }
}
a
