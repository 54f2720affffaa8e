// region: 2.3b
// fails: task_2_3_each_particle_is_in_its_bin
// story: The bins still hold what they held in the step before.
for particle in particles {
    self.put(*particle);
}
