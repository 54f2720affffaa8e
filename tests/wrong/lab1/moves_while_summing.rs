// region: 1.3
// fails: task_1_3_steps_of_a_dense_box, task_1_3_bits_of_dense_boxes, task_1_3_the_official_bytes
// story: A particle moves as soon as its own sum is complete, so those after it see it where it will be.
for i in 0..self.particles.len() {
    let particle = self.particles[i];
    let mut a = Vec2::ZERO;
    for neighbour in &self.particles {
        add_pair(&mut a, particle.to(neighbour), &mut self.observer);
    }
    advance(&mut self.particles[i], a, self.size);
}
let n = self.particles.len();
self.accelerations = vec![Vec2::ZERO; n];
