// region: 2.3b
// fails: task_2_3_each_particle_is_in_its_bin
// story: The first 1,024 bins are cleared; those behind keep what they had.
for bin in self.bins.iter_mut().take(1024) {
    bin.clear();
}
for particle in particles {
    self.put(*particle);
}
