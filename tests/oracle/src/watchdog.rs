//! Time limits, so that a test that hangs fails with a message.

use std::any::Any;
use std::cell::RefCell;
use std::env;
use std::panic::resume_unwind;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::thread;
use std::time::Duration;

/// Time limit in seconds of a test without its own limit.
const LIMIT: u64 = 120;

/// Variable with the number of seconds after which each rank of a job reports the call that it is
/// in.
pub(crate) const WATCH: &str = "CUTOFF_WATCH";

thread_local! {
    /// Name of the test whose body this thread runs.
    pub(crate) static TEST: RefCell<String> = const { RefCell::new(String::new()) };
}

/// Number of running parts of this process that have their own limits.
static OWN_LIMITS: AtomicUsize = AtomicUsize::new(0);

/// A guard that exists while a part with its own limit runs. While the guard exists, the time of
/// whole tests is not counted.
pub(crate) struct OwnLimit(());

impl OwnLimit {
    pub(crate) fn begin() -> Self {
        OWN_LIMITS.fetch_add(1, Ordering::Relaxed);
        Self(())
    }
}

impl Drop for OwnLimit {
    fn drop(&mut self) {
        OWN_LIMITS.fetch_sub(1, Ordering::Relaxed);
    }
}

/// Returns whether this process is a rank of a job that a test started.
pub(crate) fn is_rank() -> bool {
    env::var_os(WATCH).is_some()
}

/// Work for a separate thread, and its result. The boxes avoid compiling the code for threads and
/// channels again for every test.
type Work = Box<dyn FnOnce() -> Box<dyn Any + Send> + Send>;

/// Runs `work` and returns its result, or fails with the name of the task after `seconds`. A panic
/// inside is passed on unchanged.
///
/// # Panics
/// If `work` takes too long or panics.
pub fn within<T: Send + 'static>(
    task: &str,
    seconds: u64,
    work: impl FnOnce() -> T + Send + 'static,
) -> T {
    *within_boxed(task, seconds, Box::new(|| Box::new(work()))).downcast().expect("it is work's")
}

fn within_boxed(task: &str, seconds: u64, work: Work) -> Box<dyn Any + Send> {
    let _own = OwnLimit::begin();
    watch(task, seconds, |done| done.recv_timeout(Duration::from_secs(seconds)), work)
}

/// Runs the body of the test with this name, under a time limit.
///
/// # Panics
/// If `body` takes too long or panics.
pub fn watched(test: &str, body: impl FnOnce() + Send + 'static) {
    // The test that started this rank has a time limit for it.
    if is_rank() {
        return body();
    }
    let name = test.split("::").next().unwrap_or(test);
    let task = name.split('_').skip(1).take(2).collect::<Vec<_>>().join(".");
    let test = test.to_owned();
    let ends = |done: Receiver<()>| {
        let mut spent = 0;
        loop {
            let end = done.recv_timeout(Duration::from_secs(1));
            spent += u64::from(OWN_LIMITS.load(Ordering::Relaxed) == 0);
            if end != Err(RecvTimeoutError::Timeout) || spent > LIMIT {
                return end;
            }
        }
    };
    let work = move || -> Box<dyn Any + Send> {
        TEST.set(test);
        body();
        Box::new(())
    };
    watch(&task, LIMIT, ends, Box::new(work));
}

/// Runs `work` on a separate thread until it `ends`.
fn watch(
    task: &str,
    seconds: u64,
    ends: impl FnOnce(Receiver<()>) -> Result<(), RecvTimeoutError>,
    work: Work,
) -> Box<dyn Any + Send> {
    let (done, wait) = channel();
    let worker = thread::Builder::new().name(format!("task {task}"));
    let worker = worker
        .spawn(move || {
            let result = work();
            // The receiver is gone only after the time limit, when results are no longer needed.
            let _ = done.send(());
            result
        })
        .expect("the system has a thread to spare");
    if ends(wait) == Err(RecvTimeoutError::Timeout) {
        panic!(
            "task {task}: no answer within {seconds} s. The usual causes are a loop that does not end, two threads \
             that wait for each other, far more work than the task needs, or a busy machine."
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
