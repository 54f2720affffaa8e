// region: 3.11
// fails: task_3_11_all_threads_at_the_same_time
// story: Each thread is waited for before the next one is started.
let work = &work;
thread::scope(|scope| {
    for number in 0..threads {
        scope.spawn(move || work(number)).join().unwrap_or_else(|panic| resume_unwind(panic));
    }
});
