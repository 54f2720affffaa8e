// region: 1.3
// fails: task_1_3_a_step_of_any_number_of_particles
// story: Leaves out pairs whose d.x or d.y is not less than the cutoff: at exactly the cutoff along an axis a pair is not seen.
for (particle, a) in self.particles.iter().zip(&mut self.accelerations) {
    *a = Vec2::ZERO;
    for neighbour in &self.particles {
        let d = particle.to(neighbour);
        if d.x.abs() < common::soft::CUTOFF && d.y.abs() < common::soft::CUTOFF {
            add_pair(a, d, &mut self.observer);
        }
    }
}
let n = self.particles.len() as u64;
self.observer.tested(n * n);
