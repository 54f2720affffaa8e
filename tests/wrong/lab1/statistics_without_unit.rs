// region: 1.4
// fails: task_1_4_any_number_of_pairs, task_1_4_statistics_of_the_official_run
// story: Distances are not divided by the cutoff.
if r2 > 0.0 {
    self.0.dmin = self.0.dmin.min(r2.sqrt());
    self.0.davg += r2.sqrt();
    self.0.navg += 1;
}
