// region: 1.3
// fails: task_1_3_bits_of_dense_boxes
// story: The right pairs in descending order: other last digits, and after some hundred steps another picture.
for (particle, a) in self.particles.iter().zip(&mut self.accelerations) {
    *a = Vec2::ZERO;
    for neighbour in self.particles.iter().rev() {
        add_pair(a, particle.to(neighbour), &mut self.observer);
    }
}
