// region: 2.3
// fails: task_2_3_each_particle_is_in_its_bin
// story: A bin has room for 5 particles; the official scene hardly ever has more, and then a particle is lost.
let bin = &mut self.bins[self.grid.bin(&particle)];
if bin.len() < 5 {
    bin.push(particle);
}
