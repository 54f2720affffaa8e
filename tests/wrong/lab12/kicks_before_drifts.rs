// region: 10.10
// fails: task_10_10_orders_of_convergence
// story: Each kick comes before its drift: the places of the forces are wrong and the order is lost.
for (k, &fraction) in drifts.iter().enumerate() {
    if let Some(&fraction) = kicks.get(k) {
        self.kick(fraction * dt);
    }
    self.drift(fraction * dt);
}
