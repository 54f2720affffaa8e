//! Task 7.8: the division of a loop among workers.

use std::ops::Range;

use hard_discs::{Schedule, SharedCount, Team};

/// Shares out a loop over `0..n` among the workers of a team.
///
/// All workers call `body(worker, part)` at the same time, for parts that make up `0..n`. Returns
/// when all parts are done.
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

/// Returns the part of worker number `worker` (0 .. `workers`) of a loop over `0..n`.
///
/// The parts follow each other without gap or overlap. Worker 0 has the first part. The lengths of
/// the parts differ by at most 1. If there are fewer iterations than workers, some parts are empty.
///
/// Book: chapter 7, *Fixed parts*.
pub fn fixed_part(n: usize, workers: usize, worker: usize) -> Range<usize> {
    todo!("task 7.8: fixed parts")
}

/// Takes the next part of a loop over `0..n` from the queue, or returns `None` if all parts are
/// taken.
///
/// A part has `chunk` iterations; the last part may have fewer. `next` is the first iteration of
/// the next part.
///
/// All workers call this at the same time. Every iteration must be handed out exactly once. A
/// `load` followed by a `store` is two operations: another worker can change `next` between them.
///
/// Book: chapter 7, *The queue*.
pub fn next_part(next: &SharedCount, n: usize, chunk: usize) -> Option<Range<usize>> {
    todo!("task 7.8b: the queue")
}
