//! The threads that share a loop.

use std::thread;

use workers::Workers;

/// The distribution of a loop's iterations to the workers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Schedule {
    /// A fixed partition into equal parts, known before the loop starts: OpenMP's `static`.
    Static,
    /// A queue: a worker that has finished takes the next chunk. OpenMP's `dynamic`.
    Dynamic {
        /// Number of iterations in a chunk.
        chunk: usize,
    },
}

/// The threads that share a loop.
#[derive(Clone, Copy)]
pub enum Team<'t> {
    /// Threads that have been started already and wait for work.
    Standing(&'t Workers),
    /// A number of threads that are started for this loop and ended after it. OpenMP does the same
    /// for a parallel loop inside a parallel loop.
    Fresh(usize),
}

impl Team<'_> {
    /// Returns the number of threads.
    pub fn count(&self) -> usize {
        match self {
            Self::Standing(workers) => workers.count(),
            Self::Fresh(count) => *count,
        }
    }

    /// Calls `act` with the thread's number on every thread of the team, and waits: a fork and a
    /// join.
    pub fn on_each(&self, act: impl Fn(usize) + Sync) {
        match self {
            Self::Standing(workers) => workers.on_each(act),
            Self::Fresh(count) if *count > 1 => thread::scope(|scope| {
                for worker in 1..*count {
                    let act = &act;
                    scope.spawn(move || act(worker));
                }
                act(0);
            }),
            Self::Fresh(_) => act(0),
        }
    }
}
