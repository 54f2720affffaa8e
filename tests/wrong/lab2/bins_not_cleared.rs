// region: 2.3b
// fails: task_2_3_each_particle_is_in_its_bin, task_2_3_no_particle_is_left_over_or_left_out_in_1000_refills
// story: The bins still hold what they held in the step before.
for particle in particles {
    self.put(*particle);
}
