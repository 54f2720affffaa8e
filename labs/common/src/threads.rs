//! What a program says when the system refuses it a thread.

use std::fs;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;

/// How many threads somebody has asked for.
static ASKED: AtomicUsize = AtomicUsize::new(1);

/// How those who start threads complain: the standard library, the engines, and rayon.
const REFUSALS: [&str; 3] = ["failed to spawn thread", "cannot start ", "The global thread pool"];

/// Remembers how many threads somebody has asked for. A number that was `named` is tried at once, because an engine without
/// its threads may do the work alone, and take longer.
///
/// # Errors
/// The system refuses them.
pub(crate) fn ask_for(threads: usize, named: bool) -> Result<(), String> {
    ASKED.store(threads, Ordering::Relaxed);
    let could = if named { startable(threads) } else { threads };
    if could < threads { Err(too_few(could, threads)) } else { Ok(()) }
}

/// A complaint about threads in one line, with the number that could be started; `None` if it is about something else.
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

/// Threads beside the first one that run now, where the system says it.
fn running() -> usize {
    fs::read_dir("/proc/self/task").map_or(0, |tasks| tasks.count().saturating_sub(1))
}

/// How many more threads the system starts, at most `most`. They end when all have been counted.
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
