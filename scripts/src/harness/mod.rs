//! Test programs: building them, asking what tests they have, running a test by itself.
//!
//! Every test gets a process of its own, with a time limit. So a test that aborts or hangs takes
//! no other down, and what it printed is its own.

mod build;
pub(crate) mod process;
mod verdict;
mod words;

pub(crate) use build::{Build, BuildError, CompileError, TestProgram, build};
pub(crate) use process::{kill_all_on_interrupt, run as run_process, start as start_process};
pub(crate) use verdict::{Outcome, Verdict};

use std::sync::Mutex;
use std::thread;

/// Does `work` on every item, on as many threads as there are cores, and returns what came out in
/// the items' order.
pub(crate) fn on_all_cores<T: Sync, R: Send>(items: &[T], work: impl Fn(&T) -> R + Sync) -> Vec<R> {
    let cores = thread::available_parallelism().map_or(1, usize::from);
    let next = Mutex::new(items.iter().enumerate());
    let done = Mutex::new(Vec::with_capacity(items.len()));
    let take = || next.lock().expect("taking does not panic").next();
    thread::scope(|scope| {
        for _ in 0..cores.min(items.len()) {
            scope.spawn(|| {
                while let Some((index, item)) = take() {
                    let result = work(item);
                    done.lock().expect("pushing does not panic").push((index, result));
                }
            });
        }
    });
    let mut done = done.into_inner().expect("pushing does not panic");
    done.sort_by_key(|(index, _)| *index);
    done.into_iter().map(|(_, result)| result).collect()
}
