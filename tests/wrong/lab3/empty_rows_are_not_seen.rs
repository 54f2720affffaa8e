// region: 3.4
// fails: task_3_4_the_forces_on_own_particles
// story: A row without particles has no observer, and those behind it have the wrong one.
self.accelerations.clear();
self.seen.clear();
for row in self.rows.clone() {
    let mut observer = O::default();
    let before = self.accelerations.len();
    for bin in &bins.bins()[row * columns..][..columns] {
        for particle in bin {
            let a = self.gather.acceleration(particle, bins.around(particle), &mut observer);
            self.accelerations.push(a);
        }
    }
    if self.accelerations.len() > before {
        self.seen.push(observer);
    }
}
