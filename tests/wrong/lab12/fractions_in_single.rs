// region: 12.1
// fails: task_12_1_drifts_and_kicks_take_turns
// story: Fractions in single precision.
for (k, &fraction) in self.drifts.iter().enumerate() {
    motion.drift(f64::from(fraction as f32) * dt);
    if let Some(&fraction) = self.kicks.get(k) {
        motion.kick(f64::from(fraction as f32) * dt);
    }
}
