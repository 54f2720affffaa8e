//! The error of a program if the system refuses to start a thread.

use std::fs;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;

/// Number of threads that the program was last asked to start.
static ASKED: AtomicUsize = AtomicUsize::new(1);

/// Beginnings of the panic messages of `std`, the engines and rayon when no thread can be started.
const REFUSALS: [&str; 3] = ["failed to spawn thread", "cannot start ", "The global thread pool"];

/// Records the number of threads that the program needs.
///
/// A number that the user has `named` is also tested immediately, because an engine that cannot
/// start its threads may work alone, which takes longer.
///
/// # Errors
/// The system cannot start so many threads.
pub(crate) fn ask_for(threads: usize, named: bool) -> Result<(), String> {
    ASKED.store(threads, Ordering::Relaxed);
    let could = if named { startable(threads) } else { threads };
    if could < threads { Err(too_few(could, threads)) } else { Ok(()) }
}

/// Returns an error in one line, with the number of threads that could be started, for the panic
/// message `complaint`.
///
/// Returns `None` if the message is not about threads.
pub(crate) fn refusal(complaint: &str) -> Option<String> {
    if !REFUSALS.iter().any(|begin| complaint.starts_with(begin)) {
        return None;
    }
    let asked = ASKED.load(Ordering::Relaxed);
    let could = (running() + startable(asked)).min(asked.saturating_sub(1));
    Some(too_few(could, asked))
}

fn too_few(could: usize, asked: usize) -> String {
    format!(
        "only {could} of {asked} threads could be started: ask for fewer with -t, or raise the limit of this \
         machine (ulimit -u)"
    )
}

/// Returns the number of running threads except the first; 0 if the system does not report it.
fn running() -> usize {
    fs::read_dir("/proc/self/task").map_or(0, |tasks| tasks.count().saturating_sub(1))
}

/// Returns the number of further threads that the system can start, at most `most`.
///
/// The function starts the threads, counts them, and lets them end.
fn startable(most: usize) -> usize {
    let gate = Arc::new(Mutex::new(()));
    let closed = gate.lock().unwrap_or_else(PoisonError::into_inner);
    let wait = |_: &usize| {
        let gate = Arc::clone(&gate);
        thread::Builder::new().spawn(move || drop(gate.lock())).is_ok()
    };
    let started = (0..most).take_while(wait).count();
    drop(closed);
    started
}

#[cfg(test)]
mod tests {
    use super::{ask_for, refusal, startable};

    #[test]
    fn only_a_complaint_about_threads_is_one() {
        ask_for(7, true).unwrap();
        assert_eq!(startable(3), 3);
        let message = refusal("failed to spawn thread: Os { code: 11 }").unwrap();
        assert!(message.starts_with("only 6 of 7 threads could be started: "), "{message}");
        assert_eq!(refusal("index out of bounds"), None);
    }
}
