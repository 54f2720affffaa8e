// region: 3.4
// fails: task_3_4_the_forces_on_own_particles, task_3_7_fork_and_join
// loses: 3.6
// story: The last of the own rows is left out, so that its particles fly straight on.
self.accelerations.clear();
self.seen.clear();
for row in self.rows.start..self.rows.end.saturating_sub(1) {
    let mut observer = O::default();
    for particle in bins.bins()[row * columns..][..columns].iter().flatten() {
        let around = bins.around(particle);
        let a = self.gather.acceleration(particle, around, &mut observer);
        self.accelerations.push(a);
    }
    self.seen.push(observer);
}
