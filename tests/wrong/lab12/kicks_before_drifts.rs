// region: 12.1
// fails: task_12_1_drifts_and_kicks_take_turns, task_12_1_orders_of_convergence
// story: Each kick comes before its drift: the forces are those at other positions and the order is lost.
for (k, &fraction) in self.drifts.iter().enumerate() {
    if let Some(&fraction) = self.kicks.get(k) {
        motion.kick(fraction * dt);
    }
    motion.drift(fraction * dt);
}
