// region: 2.7b
// fails: task_2_7_linked_list_boxes_of_one_particle_and_a_wide_one, task_2_7_linked_list_crowds, task_2_7_linked_list_pairs_over_every_edge
// story: The neighbour is not pushed back: half of all forces are missing.
for i in self.lists.bin(bin) {
    let others = ahead.iter().flat_map(|bin| self.lists.bin(*bin));
    for j in self.lists.after(i).chain(others) {
        let d = self.particles[i].to(&self.particles[j]);
        self.observer.tested(1);
        if let Some(a) = pair_acceleration(d) {
            self.accelerations[i] += a;
            self.observer.seen(d.norm_squared());
            self.observer.seen(d.norm_squared());
        }
    }
}
