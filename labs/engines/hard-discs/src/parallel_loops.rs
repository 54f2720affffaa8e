//! How several threads share a search.

use std::ops::Range;

use crate::collisions::Candidate;
use crate::threads::{LockedCount, Schedule, SharedCount, Slots, Team};

/// Which of the two loops over pairs is shared out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Which {
    /// The loop over a: a list for each thread.
    Outer,
    /// The loop over b: a list for each thread.
    Inner,
    /// Both, the inner one by a fresh team of as many threads: a list for each thread of each thread's team.
    Nested,
}

/// Loops that threads share out, and an array that they fill together.
pub trait ParallelLoops {
    /// Runs a loop over `0..n`: calls `body(worker, part)`, on all threads of a team, for parts that together are
    /// `0..n`.
    fn parallel_for(
        n: usize,
        team: Team,
        schedule: Schedule,
        body: impl Fn(usize, Range<usize>) + Sync,
    );

    /// All pairs a < b of `n` discs, with `which` loop shared out; of two loops the outer one by `schedule`.
    ///
    /// `look(list, a, partners)` looks at disc a and every disc in `partners`, and puts what it finds into list number
    /// `list`. No two threads use the same list at the same time.
    fn all_pairs(
        which: Which,
        n: usize,
        team: Team,
        schedule: Schedule,
        look: impl Fn(usize, usize, Range<usize>) + Sync,
    );

    /// Appends a candidate to an array that all threads write into, whose counter is behind a lock.
    fn append_locked(list: &Slots, count: &LockedCount, candidate: Candidate);

    /// The same with an atomic counter.
    fn append_atomic(list: &Slots, count: &SharedCount, candidate: Candidate);
}
