// region: 4.1
// fails: task_4_1_everybody_is_in_a_bin_again, task_4_1_one_thread_rebuilds
// story: The list from the step before is not cleared, so everybody is there twice.
all.extend(bins.particles());
all.extend(buffers.flatten());
bins.refill(all);
