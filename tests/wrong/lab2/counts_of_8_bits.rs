// region: 2.8
// fails: task_2_8_particles_lie_in_the_order_of_their_bins
// story: The particles of a bin are counted in 8 bits: a bin of 256 has none.
self.starts.fill(0);
for particle in &self.unsorted {
    let count = &mut self.starts[bin_of(particle)];
    *count = u32::from((*count as u8).wrapping_add(1));
}
let mut sum = 0;
for start in &mut self.starts {
    sum += *start;
    *start = sum;
}
for particle in self.unsorted.iter().rev() {
    let end = &mut self.starts[bin_of(particle)];
    *end = end.wrapping_sub(1);
    if let Some(there) = self.particles.get_mut(*end as usize) {
        *there = *particle;
    }
}
