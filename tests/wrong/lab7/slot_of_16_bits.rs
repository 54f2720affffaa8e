// region: 7.10
// fails: task_7_10_each_candidate_has_a_slot_of_its_own
// story: The slot is counted in 16 bits.
let slot = count.locked(|count| {
    *count += 1;
    (*count - 1) & 0xffff
});
list.put(slot, candidate);
