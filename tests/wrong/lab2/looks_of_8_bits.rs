// region: 2.4
// fails: task_2_4_each_particle_of_nine_bins_once
// story: The size of a bin is told in 8 bits.
let mut a = Vec2::ZERO;
for row in self.grid.near(self.grid.row(particle.y)) {
    for column in self.grid.near(self.grid.column(particle.x)) {
        let bin = &self.bins[row * self.grid.columns() + column];
        observer.tested(u64::from(bin.len() as u8));
        for neighbour in bin {
            add_pair(&mut a, particle.to(neighbour), observer);
        }
    }
}
a
