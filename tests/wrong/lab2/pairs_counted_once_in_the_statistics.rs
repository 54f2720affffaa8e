// region: 2.7b
// fails: task_2_7_linked_list_statistics
// story: A pair is seen once and not as the two ordered pairs that it is: the physics is right, navg is half.
for i in self.lists.bin(bin) {
    let others = ahead.iter().flat_map(|bin| self.lists.bin(*bin));
    for j in self.lists.after(i).chain(others) {
        let d = self.particles[i].to(&self.particles[j]);
        self.observer.tested(1);
        if let Some(a) = pair_acceleration(d) {
            self.accelerations[i] += a;
            self.accelerations[j] -= a;
            self.observer.seen(d.norm_squared());
        }
    }
}
