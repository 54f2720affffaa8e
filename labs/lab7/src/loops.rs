//! Task 7.9: three ways to share out the two loops over all pairs.
//!
//! Each of the three functions looks at all pairs a < b of `n` discs. In the outer loop, a counts
//! up from 0. In the inner loop, b counts up from a + 1. `look(list, a, partners)` looks at disc a
//! and every disc in `partners`, and appends the candidates to list number `list`. Two threads may
//! not use the same list at the same time: one would wait for the other.

use std::ops::Range;

use hard_discs::{Schedule, Team};

use crate::schedule::parallel_for;

/// Shares out the outer loop (the report's p1), with one fork and join.
///
/// Worker w searches whole rows, and writes into list w. [`parallel_for`] calls its `body` with the
/// number of a worker and a part of the loop.
///
/// Book: chapter 7, *Which loop*.
pub fn outer(
    n: usize,
    team: Team,
    schedule: Schedule,
    look: impl Fn(usize, usize, Range<usize>) + Sync,
) {
    todo!("task 7.9: the outer loop shared out")
}

/// Shares out the inner loop (the report's p2), with n forks and joins.
///
/// Worker w searches a part of every row, and writes into list w. The row of disc a is searched by a
/// loop over `0..n - a - 1`. Iteration 0 of this loop looks at disc a + 1.
///
/// Book: chapter 7, *Which loop*.
pub fn inner(
    n: usize,
    team: Team,
    schedule: Schedule,
    look: impl Fn(usize, usize, Range<usize>) + Sync,
) {
    todo!("task 7.9b: the inner loop shared out")
}

/// Shares out both loops (the report's p3).
///
/// - The members of `team` share the outer loop by `schedule`.
/// - For each of its rows, a worker of `team` starts a new team of the same size,
///   `Team::Fresh(team.count())`, and splits the row into fixed parts for the new team.
/// - Several rows are searched at the same time, so one list for each member of `team` is not
///   enough. If worker w starts a new team, member m of the new team has list
///   w × `team.count()` + m.
///
/// Book: chapter 7, *Which loop*.
pub fn nested(
    n: usize,
    team: Team,
    schedule: Schedule,
    look: impl Fn(usize, usize, Range<usize>) + Sync,
) {
    todo!("task 7.9c: both loops shared out")
}
