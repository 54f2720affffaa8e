// region: 2.3
// fails: task_2_3_each_particle_is_in_its_bin
// story: A bin has room for 1,024 particles; the next are lost.
let bin = &mut self.bins[self.grid.bin(&particle)];
if bin.len() < 1024 {
    bin.push(particle);
}
