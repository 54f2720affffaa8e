// region: 2.8
// fails: task_2_8_particles_lie_in_the_order_of_their_bins
// story: Numbers of bins are kept in 16 bits.
self.starts.fill(0);
for particle in &self.unsorted {
    self.starts[bin_of(particle) as u16 as usize] += 1;
}
let mut sum = 0;
for start in &mut self.starts {
    sum += *start;
    *start = sum;
}
for particle in self.unsorted.iter().rev() {
    let end = &mut self.starts[bin_of(particle) as u16 as usize];
    *end -= 1;
    self.particles[*end as usize] = *particle;
}
