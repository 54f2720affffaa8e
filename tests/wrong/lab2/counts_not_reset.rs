// region: 2.8
// fails: task_2_8_particles_lie_in_the_order_of_their_bins
// story: The counts of the step before are still there: the bins end beyond the array.
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
