// region: 2.8
// fails: task_2_8_particles_lie_in_the_order_of_their_bins
// story: If the particles are in the order of their bins already it returns, with the starts of the time before.
let total = self.unsorted.len() as u32;
if self.starts.last() == Some(&total) && self.unsorted.is_sorted_by_key(bin_of) {
    self.particles.copy_from_slice(&self.unsorted);
    return;
}
self.starts.fill(0);
for particle in &self.unsorted {
    self.starts[bin_of(particle)] += 1;
}
let mut sum = 0;
for start in &mut self.starts {
    sum += *start;
    *start = sum;
}
for particle in self.unsorted.iter().rev() {
    let end = &mut self.starts[bin_of(particle)];
    *end -= 1;
    self.particles[*end as usize] = *particle;
}
