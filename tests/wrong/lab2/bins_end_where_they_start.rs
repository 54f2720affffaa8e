// region: 2.8
// fails: task_2_8_particles_lie_in_the_order_of_their_bins
// story: The bins keep where they end and not where they start: every bin shows the particles of the next.
let mut next = vec![0; self.starts.len()];
for particle in &self.unsorted {
    next[bin_of(particle)] += 1;
}
let mut sum = 0;
for (start, next) in self.starts.iter_mut().zip(&mut next) {
    let count = *next;
    *next = sum;
    sum += count;
    *start = sum;
}
for particle in &self.unsorted {
    let end: &mut u32 = &mut next[bin_of(particle)];
    self.particles[*end as usize] = *particle;
    *end += 1;
}
