// region: 4.1
// fails: task_4_1_everybody_is_in_a_bin_again, task_4_1_one_thread_rebuilds
// story: Only those in bins are collected. Who is in a change buffer at that moment is lost.
all.clear();
all.extend(bins.particles());
let _ = buffers;
bins.refill(all);
