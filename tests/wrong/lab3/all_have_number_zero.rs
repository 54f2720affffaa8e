// region: 3.11
// fails: task_3_11_all_threads_at_the_same_time, task_3_11_the_team
// story: Every thread gets the same number, and so the same rows.
let work = &work;
thread::scope(|scope| {
    let threads: Vec<_> = (0..threads).map(|_| scope.spawn(move || work(0))).collect();
    for thread in threads {
        thread.join().unwrap_or_else(|panic| resume_unwind(panic));
    }
});
