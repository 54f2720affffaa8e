// region: 1.3
// fails: task_1_3_steps_of_a_dense_box, task_1_3_forces_of_crowds_add_up, task_1_3_pairs_at_the_cutoff
// story: Each pair once, but only one of the two is pushed.
for (i, (particle, a)) in self.particles.iter().zip(&mut self.accelerations).enumerate() {
    *a = Vec2::ZERO;
    for neighbour in &self.particles[i..] {
        add_pair(a, particle.to(neighbour), &mut self.observer);
    }
}
