// region: 2.4
// fails: task_2_4_each_particle_of_nine_bins_once
// story: Every bin is looked at, and the observer is told of nine: the work of a step, as all-pairs does it, looks like that of bins.
let mut a = Vec2::ZERO;
for row in 0..self.grid.rows() {
    for column in 0..self.grid.columns() {
        let bin = &self.bins[row * self.grid.columns() + column];
        let rows = self.grid.near(self.grid.row(particle.y));
        if rows.contains(&row) && self.grid.near(self.grid.column(particle.x)).contains(&column) {
            observer.tested(bin.len() as u64);
        }
        for neighbour in bin {
            add_pair(&mut a, particle.to(neighbour), observer);
        }
    }
}
a
