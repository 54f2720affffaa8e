//! Task 7.9: which of the two loops over all pairs is shared out.
//!
//! Each of the three looks at all pairs a < b of `n` discs: a from 0 up in the outer loop, b from a + 1 up in the inner
//! one. `look(list, a, partners)` looks at disc a and every disc in `partners`, and puts what it finds into list number
//! `list`. No two threads may use the same list at the same time: one would wait for the other.

use std::ops::Range;

use hard_discs::{Schedule, Team};

use crate::schedule::parallel_for;

/// The outer loop is shared out (the report's p1): one fork and join. Worker w does whole rows and writes into
/// list w.
///
/// [`parallel_for`] calls what you give it with a worker's number and a part of the loop.
///
/// Book: chapter 7, *Which loop*.
pub fn outer(
    n: usize,
    team: Team,
    schedule: Schedule,
    look: impl Fn(usize, usize, Range<usize>) + Sync,
) {
    // task 7.9: the outer loop shared out
    parallel_for(n, team, schedule, |worker, part| {
        for a in part {
            look(worker, a, a + 1..n);
        }
    });
    // end 7.9
}

/// The inner loop is shared out (the report's p2): n forks and joins. Each worker has a part of every row.
///
/// The row of disc a is a loop over `0..n - a - 1`, whose first iteration is disc a + 1.
///
/// Book: chapter 7, *Which loop*.
pub fn inner(
    n: usize,
    team: Team,
    schedule: Schedule,
    look: impl Fn(usize, usize, Range<usize>) + Sync,
) {
    // task 7.9b: the inner loop shared out
    for a in 0..n {
        let first = a + 1;
        parallel_for(n - first, team, schedule, |worker, part| {
            look(worker, a, first + part.start..first + part.end);
        });
    }
    // end 7.9b
}

/// Both loops are shared out (the report's p3). `team` shares the outer loop by `schedule`; each of its workers shares
/// each of its rows in fixed parts with a team of its own, started for this row: `Team::Fresh(team.count())`.
///
/// Several rows are looked at at the same time, so a list for each member of one team is not enough: member m of
/// worker w's teams has list w × (size of a team) + m.
///
/// Book: chapter 7, *Which loop*.
pub fn nested(
    n: usize,
    team: Team,
    schedule: Schedule,
    look: impl Fn(usize, usize, Range<usize>) + Sync,
) {
    // task 7.9c: both loops shared out
    let count = team.count();
    parallel_for(n, team, schedule, |worker, part| {
        for a in part {
            let first = a + 1;
            parallel_for(n - first, Team::Fresh(count), Schedule::Static, |member, part| {
                look(worker * count + member, a, first + part.start..first + part.end);
            });
        }
    });
    // end 7.9c
}
