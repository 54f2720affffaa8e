// region: 1.4
// fails: task_1_4_any_number_of_pairs
// story: Pairs are counted in 16 bits.
if r2 > 0.0 {
    let r = (r2 / (CUTOFF * CUTOFF)).sqrt();
    self.0.dmin = self.0.dmin.min(r);
    self.0.davg += r;
    self.0.navg = u64::from((self.0.navg as u16).wrapping_add(1));
}
