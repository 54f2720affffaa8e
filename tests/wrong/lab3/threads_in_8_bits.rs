// region: 3.11
// fails: task_3_11_all_threads_at_the_same_time
// story: The number of threads in eight bits: of 257 one starts.
let work = &work;
thread::scope(|scope| {
    let threads: Vec<_> =
        (0..threads as u8).map(|number| scope.spawn(move || work(number.into()))).collect();
    for thread in threads {
        thread.join().unwrap_or_else(|panic| resume_unwind(panic));
    }
});
