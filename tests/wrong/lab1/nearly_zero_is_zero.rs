// region: 1.4
// fails: task_1_4_any_number_of_pairs
// story: A distance that is very small is taken for zero.
if r2 > 1e-30 {
    let r = (r2 / (CUTOFF * CUTOFF)).sqrt();
    self.0.dmin = self.0.dmin.min(r);
    self.0.davg += r;
    self.0.navg += 1;
}
