// region: 12.1
// fails: task_12_1_drifts_and_kicks_take_turns
// story: The last drift is what is left of the step.
let mut left = 1.0;
let last = self.drifts.len() - 1;
for (k, &fraction) in self.drifts.iter().enumerate() {
    motion.drift(if k == last { left * dt } else { fraction * dt });
    left -= fraction;
    if let Some(&fraction) = self.kicks.get(k) {
        motion.kick(fraction * dt);
    }
}
