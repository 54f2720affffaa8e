// region: 2.4
// fails: task_2_4_each_particle_of_nine_bins_once
// story: For a particle exactly on the far wall the column behind it is counted and nothing is seen to the left: a particle at x = size does not feel the bin left of its own.
let mut a = Vec2::ZERO;
let on_the_wall = particle.x >= self.grid.size();
for row in self.grid.near(self.grid.row(particle.y)) {
    let mut columns = self.grid.near(self.grid.column(particle.x));
    if on_the_wall {
        columns.start = self.grid.column(particle.x);
    }
    for column in columns {
        let bin = &self.bins[row * self.grid.columns() + column];
        observer.tested(bin.len() as u64);
        for neighbour in bin {
            add_pair(&mut a, particle.to(neighbour), observer);
        }
    }
}
a
