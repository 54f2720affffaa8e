// region: 1.3
// fails: task_1_3_a_step_of_any_number_of_particles
// story: The observer is never told how many pairs were looked at: the work of a step, which later labs are judged by.
for (particle, a) in self.particles.iter().zip(&mut self.accelerations) {
    *a = Vec2::ZERO;
    for neighbour in &self.particles {
        add_pair(a, particle.to(neighbour), &mut self.observer);
    }
}
