// region: 12.1
// fails: task_12_1_drifts_and_kicks_take_turns
// story: A drift of 0 is left out, and with it the kick behind it.
for (k, &fraction) in self.drifts.iter().enumerate() {
    if fraction == 0.0 && k > 0 && k + 1 < self.drifts.len() {
        continue;
    }
    motion.drift(fraction * dt);
    if let Some(&fraction) = self.kicks.get(k) {
        motion.kick(fraction * dt);
    }
}
