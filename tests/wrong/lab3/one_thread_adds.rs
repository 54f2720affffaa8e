// region: 3.2
// fails: task_3_2_the_threads_share_the_parts
// story: There is a lock, and no thread to keep out: one thread adds all parts.
let total = Mutex::new(O::default());
parts.iter().for_each(|part| total.lock().merge(part));
total.into_inner()
