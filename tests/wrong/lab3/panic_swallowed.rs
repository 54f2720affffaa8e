// region: 3.11
// fails: task_3_11_a_panic_comes_out_with_its_words
// story: A thread that panics is waited for like any other, and the step ends as if nothing had happened.
let work = &work;
thread::scope(|scope| {
    let threads: Vec<_> =
        (0..threads).map(|number| scope.spawn(move || work(number))).collect();
    for thread in threads {
        let _ = thread.join();
    }
});
