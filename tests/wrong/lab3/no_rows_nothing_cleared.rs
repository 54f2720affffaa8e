// region: 3.4
// fails: task_3_4_the_forces_on_own_particles
// story: A worker without rows keeps the accelerations of the step before.
if self.rows.is_empty() {
    return;
}
self.accelerations.clear();
self.seen.clear();
for row in self.rows.clone() {
    let mut observer = O::default();
    for bin in &bins.bins()[row * columns..][..columns] {
        for particle in bin {
            let a = self.gather.acceleration(particle, bins.around(particle), &mut observer);
            self.accelerations.push(a);
        }
    }
    self.seen.push(observer);
}
