//! Task 7.8: which worker does which part of a loop.

use std::ops::Range;
use std::thread;

use crate::{SharedCount, Workers};

/// How the iterations of a loop are dealt out to the workers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Schedule {
    /// A fixed partition: equal parts, known before the loop starts. OpenMP's `static`.
    Static,
    /// A queue: a worker that is done takes the next chunk. OpenMP's `dynamic`.
    Dynamic {
        /// Iterations in a chunk.
        chunk: usize,
    },
}

/// The threads that share a loop.
#[derive(Clone, Copy)]
pub enum Team<'t> {
    /// Threads that exist and wait for work.
    Standing(&'t Workers),
    /// As many threads, started for this one loop and ended after it. This is what OpenMP does
    /// for a parallel loop inside a parallel loop.
    Fresh(usize),
}

impl Team<'_> {
    /// How many threads.
    pub fn count(&self) -> usize {
        match self {
            Self::Standing(workers) => workers.count(),
            Self::Fresh(count) => *count,
        }
    }

    /// Calls `act` once on every thread of the team, with the thread's number, and waits for all.
    fn on_each(&self, act: impl Fn(usize) + Sync) {
        match self {
            Self::Standing(Workers::Many(pool)) => {
                pool.broadcast(|context| act(context.index()));
            }
            Self::Fresh(count) if *count > 1 => thread::scope(|scope| {
                for worker in 1..*count {
                    let act = &act;
                    scope.spawn(move || act(worker));
                }
                act(0);
            }),
            _ => act(0),
        }
    }

    /// Runs a loop over `0..n`: calls `body(worker, part)` for parts that together are 0..n.
    pub fn run(&self, n: usize, schedule: Schedule, body: impl Fn(usize, Range<usize>) + Sync) {
        match schedule {
            Schedule::Static => {
                self.on_each(|worker| body(worker, fixed_part(n, self.count(), worker)));
            }
            Schedule::Dynamic { chunk } => {
                let next = SharedCount::default();
                self.on_each(|worker| {
                    while let Some(part) = next_part(&next, n, chunk) {
                        body(worker, part);
                    }
                });
            }
        }
    }
}

/// The part of worker number `worker` (0 .. `workers`) of a loop over `0..n`.
///
/// Parts follow each other without gap or overlap, worker 0 first, and their lengths differ by at
/// most 1. With fewer iterations than workers some parts are empty.
///
/// Book: chapter 7, *Fixed parts*.
pub fn fixed_part(n: usize, workers: usize, worker: usize) -> Range<usize> {
    // task 7.8: fixed parts
    worker * n / workers..(worker + 1) * n / workers
    // end 7.8
}

/// Takes the next part of a loop over `0..n` from the queue: `chunk` iterations, fewer at the end,
/// none when all are taken.
///
/// `next` is where the next part begins. All workers call this at the same time: no iteration may
/// be handed out twice or be lost. A `load` and then a `store` are two steps, and another worker
/// can come between them.
///
/// Book: chapter 7, *The queue*.
pub fn next_part(next: &SharedCount, n: usize, chunk: usize) -> Option<Range<usize>> {
    // task 7.8b: the queue
    let start = next.fetch_add(chunk);
    (start < n).then(|| start..n.min(start + chunk))
    // end 7.8b
}
