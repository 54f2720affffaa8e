// region: 3.4
// fails: task_3_4_the_forces_on_own_particles
// story: The list of accelerations is not cleared: the particles get those of the step before.
for row in self.rows.clone() {
    let mut observer = O::default();
    for particle in bins.bins()[row * columns..][..columns].iter().flatten() {
        let around = bins.around(particle);
        let a = self.gather.acceleration(particle, around, &mut observer);
        self.accelerations.push(a);
    }
    self.seen.push(observer);
}
