// region: 1.3
// fails: task_1_3_a_step_of_any_number_of_particles
// story: The number of looks is computed in 16 bits: 256 particles look at none.
for (particle, a) in self.particles.iter().zip(&mut self.accelerations) {
    *a = Vec2::ZERO;
    for neighbour in &self.particles {
        add_pair(a, particle.to(neighbour), &mut self.observer);
    }
}
let n = self.particles.len() as u16;
self.observer.tested(u64::from(n.wrapping_mul(n)));
