//! A test that hangs must say so.

use std::panic::resume_unwind;
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::Duration;

/// Runs `work` and returns its result, or fails with the name of the task if that takes longer
/// than `seconds`. A panic inside comes out as it was.
///
/// # Panics
/// `work` took too long or panicked.
pub fn within<T: Send + 'static>(
    task: &str,
    seconds: u64,
    work: impl FnOnce() -> T + Send + 'static,
) -> T {
    let (done, wait) = channel();
    let worker = thread::Builder::new().name(format!("task {task}"));
    let worker = worker
        .spawn(move || {
            let result = work();
            // The receiver is gone only if the time is up, and then nothing is received.
            let _ = done.send(());
            result
        })
        .expect("the system has a thread to spare");
    if wait.recv_timeout(Duration::from_secs(seconds)) == Err(RecvTimeoutError::Timeout) {
        panic!(
            "task {task}: no answer within {seconds} s. Either a loop does not end, or two \
             threads wait for each other."
        );
    }
    worker.join().unwrap_or_else(|panic| resume_unwind(panic))
}

#[cfg(test)]
mod tests {
    use super::within;

    #[test]
    fn a_result_comes_back() {
        assert_eq!(within("0.0", 5, || 6 * 7), 42);
    }

    #[test]
    #[should_panic(expected = "task 4.3: no answer within 1 s")]
    fn a_hang_names_its_task() {
        within("4.3", 1, || {
            loop {
                std::thread::park();
            }
        });
    }

    #[test]
    #[should_panic(expected = "own words")]
    fn a_panic_keeps_its_words() {
        within("0.0", 5, || panic!("own words"));
    }
}
