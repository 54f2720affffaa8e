// region: 2.4
// fails: task_2_4_each_particle_of_nine_bins_once
// story: Of a bin the first thousand are looked at.
let mut a = Vec2::ZERO;
for row in self.grid.near(self.grid.row(particle.y)) {
    for column in self.grid.near(self.grid.column(particle.x)) {
        let bin = &self.bins[row * self.grid.columns() + column];
        observer.tested(bin.len() as u64);
        for neighbour in bin.iter().take(1000) {
            add_pair(&mut a, particle.to(neighbour), observer);
        }
    }
}
a
