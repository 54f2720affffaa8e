// region: 3.11
// fails: task_3_11_a_panic_comes_out_with_its_words
// story: A panic is answered by another one, with other words: what went wrong cannot be read.
let work = &work;
thread::scope(|scope| {
    let threads: Vec<_> =
        (0..threads).map(|number| scope.spawn(move || work(number))).collect();
    for thread in threads {
        thread.join().expect("no thread panics");
    }
});
