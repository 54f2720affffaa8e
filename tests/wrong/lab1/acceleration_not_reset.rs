// region: 1.3
// fails: task_1_3_steps_of_a_dense_box, task_1_3_the_official_run, task_1_3_the_official_bytes
// story: The accelerations of the step before are still there when the sum begins.
for (particle, a) in self.particles.iter().zip(&mut self.accelerations) {
    for neighbour in &self.particles {
        add_pair(a, particle.to(neighbour), &mut self.observer);
    }
}
