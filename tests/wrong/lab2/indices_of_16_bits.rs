// region: 2.8
// fails: task_2_8_particles_lie_in_the_order_of_their_bins
// story: Indices are summed in 16 bits: with more than 65,535 particles they begin again at 0.
self.starts.fill(0);
for particle in &self.unsorted {
    self.starts[bin_of(particle)] += 1;
}
let mut sum = 0_u16;
for start in &mut self.starts {
    sum = sum.wrapping_add(*start as u16);
    *start = u32::from(sum);
}
for particle in self.unsorted.iter().rev() {
    let end = &mut self.starts[bin_of(particle)];
    *end = end.wrapping_sub(1);
    if let Some(there) = self.particles.get_mut(*end as usize) {
        *there = *particle;
    }
}
