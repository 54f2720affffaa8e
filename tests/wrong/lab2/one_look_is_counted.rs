// region: 2.4
// fails: task_2_4_each_particle_of_nine_bins_once
// story: The observer is told of one pair, however many are looked at.
let mut a = Vec2::ZERO;
observer.tested(1);
for row in self.grid.near(self.grid.row(particle.y)) {
    for column in self.grid.near(self.grid.column(particle.x)) {
        for neighbour in &self.bins[row * self.grid.columns() + column] {
            add_pair(&mut a, particle.to(neighbour), observer);
        }
    }
}
a
