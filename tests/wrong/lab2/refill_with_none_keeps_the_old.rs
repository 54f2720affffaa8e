// region: 2.3b
// fails: task_2_3_each_particle_is_in_its_bin
// story: With no particles to put in, the bins are not cleared.
if particles.is_empty() {
    return;
}
for bin in &mut self.bins {
    bin.clear();
}
for particle in particles {
    self.put(*particle);
}
