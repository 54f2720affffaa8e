// region: 1.3
// fails: task_1_3_memory_does_not_grow
// story: The new sums are put in front of the old ones, which nobody reads again and nobody drops.
let mut sums = vec![Vec2::ZERO; self.particles.len()];
for (particle, a) in self.particles.iter().zip(&mut sums) {
    for neighbour in &self.particles {
        add_pair(a, particle.to(neighbour), &mut self.observer);
    }
}
self.accelerations.splice(0..0, sums);
let n = self.particles.len() as u64;
self.observer.tested(n * n);
