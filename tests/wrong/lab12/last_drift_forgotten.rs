// region: 12.1
// fails: task_12_1_drifts_and_kicks_take_turns, task_12_1_euler_is_the_official_step
// story: Drifts and kicks are taken in pairs, and the last drift has no partner: it is left out.
for (drift, kick) in self.drifts.iter().zip(&self.kicks) {
    motion.drift(drift * dt);
    motion.kick(kick * dt);
}
