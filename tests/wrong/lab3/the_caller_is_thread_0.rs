// region: 3.11
// fails: task_3_11_all_threads_at_the_same_time
// story: The thread that calls does the work of thread 0.
let work = &work;
thread::scope(|scope| {
    let others: Vec<_> = (1..threads).map(|number| scope.spawn(move || work(number))).collect();
    if threads > 0 {
        work(0);
    }
    for thread in others {
        thread.join().unwrap_or_else(|panic| resume_unwind(panic));
    }
});
