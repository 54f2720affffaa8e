// region: 1.3
// fails: task_1_3_a_step_of_any_number_of_particles
// story: A particle looks at the first 4,096 only.
for (particle, a) in self.particles.iter().zip(&mut self.accelerations) {
    *a = Vec2::ZERO;
    for neighbour in self.particles.iter().take(4096) {
        add_pair(a, particle.to(neighbour), &mut self.observer);
    }
}
let n = self.particles.len() as u64;
self.observer.tested(n * n);
