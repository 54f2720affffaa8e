// region: 1.4
// fails: task_1_4_any_number_of_pairs, task_1_4_statistics_of_dense_boxes, task_1_4_statistics_of_the_official_run
// story: The particle's distance to itself, zero, is taken for a pair.
let r = (r2 / (CUTOFF * CUTOFF)).sqrt();
self.0.dmin = self.0.dmin.min(r);
self.0.davg += r;
self.0.navg += 1;
