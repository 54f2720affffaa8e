// region: 3.2
// fails: task_3_2_the_threads_share_the_parts
// story: Each thread reads the total, adds its part and writes it back. What other threads wrote in between is lost, and every access is under a lock.
let total = Mutex::new(O::default());
parts.par_iter().for_each(|part| {
    let mut sum = total.lock().clone();
    sum.merge(part);
    *total.lock() = sum;
});
total.into_inner()
