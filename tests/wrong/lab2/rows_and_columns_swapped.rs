// region: 2.3
// fails: task_2_3_each_particle_is_in_its_bin
// story: The row and the column are swapped when a particle is put away, and nowhere else.
let bin = self.grid.column(particle.x) * self.grid.columns() + self.grid.row(particle.y);
self.bins[bin].push(particle);
