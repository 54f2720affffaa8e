// region: 7.10
// fails: task_7_10_each_candidate_has_a_slot_of_its_own, task_7_10_one_list_holds_what_many_lists_hold
// story: The count is raised first and then read, so that slot 0 stays empty and the last candidate lies behind the end.
let slot = count.locked(|count| {
    *count += 1;
    *count
});
list.put(slot, candidate);
