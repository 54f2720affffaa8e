// region: 2.8
// fails: task_2_8_particles_lie_in_the_order_of_their_bins
// story: Placed from the first to the last, the particles of a bin come out in the reverse order, in every step again.
self.starts.fill(0);
for particle in &self.unsorted {
    self.starts[bin_of(particle)] += 1;
}
let mut sum = 0;
for start in &mut self.starts {
    sum += *start;
    *start = sum;
}
for particle in &self.unsorted {
    let end = &mut self.starts[bin_of(particle)];
    *end -= 1;
    self.particles[*end as usize] = *particle;
}
