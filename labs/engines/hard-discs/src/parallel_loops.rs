//! The interface for searches that several threads share.

use std::ops::Range;

use crate::collisions::Candidate;
use crate::threads::{LockedCount, Schedule, SharedCount, Slots, Team};

/// The loop over pairs a < b that threads share.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Which {
    /// The outer loop, over a, with a list for each thread.
    Outer,
    /// The inner loop, over b, with a list for each thread.
    Inner,
    /// Both loops. New teams of as many threads run the inner loops, with a list for each thread of
    /// each team.
    Nested,
}

/// Parallel loops, and an array that threads fill together.
pub trait ParallelLoops {
    /// Runs a loop over `0..n`: the threads of a team call `body(worker, part)` for parts of the
    /// range.
    fn parallel_for(
        n: usize,
        team: Team,
        schedule: Schedule,
        body: impl Fn(usize, Range<usize>) + Sync,
    );

    /// Visits all pairs a < b of `n` discs, and divides `which` loop among threads.
    ///
    /// If both loops are divided, `schedule` applies to the outer loop. `look(list, a, partners)`
    /// tests disc a with every disc in `partners`, and stores the candidates in list number `list`.
    /// No two threads use the same list at the same time.
    fn all_pairs(
        which: Which,
        n: usize,
        team: Team,
        schedule: Schedule,
        look: impl Fn(usize, usize, Range<usize>) + Sync,
    );

    /// Appends a candidate to an array that all threads write to. A lock protects the array's
    /// counter.
    fn append_locked(list: &Slots, count: &LockedCount, candidate: Candidate);

    /// Appends a candidate to an array that all threads write to. The array's counter is atomic.
    fn append_atomic(list: &Slots, count: &SharedCount, candidate: Candidate);
}
