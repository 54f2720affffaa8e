// region: 3.4
// fails: task_3_4_the_forces_on_own_particles
// story: The rows' observers stand in reverse: the sums are right up to their last digits, which now depend on the cuts.
self.accelerations.clear();
self.seen.clear();
for row in self.rows.clone() {
    let mut observer = O::default();
    for particle in bins.bins()[row * columns..][..columns].iter().flatten() {
        let around = bins.around(particle);
        let a = self.gather.acceleration(particle, around, &mut observer);
        self.accelerations.push(a);
    }
    self.seen.insert(0, observer);
}
