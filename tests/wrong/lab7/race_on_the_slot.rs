// region: 7.10b
// fails: task_7_10_no_thread_comes_between_a_load_and_a_store
// story: A load and then a store: between the two another worker reads the same count, and both write into the same slot. A candidate is lost; on most days none is.
let slot = count.load();
count.store(slot + 1);
list.put(slot, candidate);
