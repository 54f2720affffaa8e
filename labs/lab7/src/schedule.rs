//! Task 7.8: which worker does which part of a loop.

use std::ops::Range;

use hard_discs::{Schedule, SharedCount, Team};

/// A loop over `0..n`, shared out: calls `body(worker, part)`, on all workers of a team at the same time, for parts that
/// together are `0..n`. Returns when all are done.
pub fn parallel_for(
    n: usize,
    team: Team,
    schedule: Schedule,
    body: impl Fn(usize, Range<usize>) + Sync,
) {
    match schedule {
        Schedule::Static => {
            team.on_each(|worker| body(worker, fixed_part(n, team.count(), worker)));
        }
        Schedule::Dynamic { chunk } => {
            let next = SharedCount::default();
            team.on_each(|worker| {
                while let Some(part) = next_part(&next, n, chunk) {
                    body(worker, part);
                }
            });
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
    todo!("task 7.8: fixed parts")
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
    todo!("task 7.8b: the queue")
}
