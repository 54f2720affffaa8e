// region: 7.8b
// fails: task_7_8_no_thread_comes_between_a_load_and_a_store
// story: A load and then a store: between the two another worker reads the same count, and both take the same part, so that candidates are found twice. On most days no worker comes between.
let start = next.load();
next.store(start + chunk);
(start < n).then(|| start..n.min(start + chunk))
