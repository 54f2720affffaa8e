// region: 7.10b
// fails: task_7_10_each_candidate_has_a_slot_of_its_own
// story: The slot is counted in 16 bits.
list.put(count.fetch_add(1) & 0xffff, candidate);
