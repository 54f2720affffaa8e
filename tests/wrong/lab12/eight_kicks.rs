// region: 12.1
// fails: task_12_1_drifts_and_kicks_take_turns
// story: At most eight kicks.
for (k, &fraction) in self.drifts.iter().enumerate() {
    motion.drift(fraction * dt);
    if let Some(&fraction) = self.kicks.get(k).filter(|_| k < 8) {
        motion.kick(fraction * dt);
    }
}
