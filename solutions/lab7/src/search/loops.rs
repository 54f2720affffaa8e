//! All pairs: by one thread, and by several.

use std::ops::Range;

use common::hard::Disc;

use super::{Find, Found, Lists};
use crate::{
    LockedCount, Schedule, SharedCount, Slots, Square, Team, Window, Workers, append_atomic,
    append_locked, inner, look_along, look_for, nested, outer,
};

/// All pairs a < b, by one thread.
pub struct AllPairs;

impl Find for AllPairs {
    fn find(&mut self, discs: &[Disc], _: &[bool], square: Square, _: Window, found: &mut Found) {
        let n = discs.len();
        let list = found.lists.first_mut().expect("Found::clear was called, and made a list");
        for a in 0..n {
            look_along(discs, a, a + 1..n, square.radius, list);
            found.pair_tests += (n - a - 1) as u64;
        }
    }
}

/// Which of the two loops is shared out: tasks 7.9, 7.9b and 7.9c.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Which {
    /// The loop over a.
    Outer,
    /// The loop over b.
    Inner,
    /// Both.
    Nested,
}

/// Where workers put the candidates that they find.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Collect {
    /// Each into a list of its own.
    Own,
    /// All into one array, whose counter is behind a lock (task 7.10).
    Locked,
    /// All into one array, whose counter is atomic (task 7.10b).
    Atomic,
}

/// All pairs a < b, by several threads.
pub struct Loops {
    which: Which,
    schedule: Schedule,
    collect: Collect,
    workers: Workers,
    shared: Slots,
}

impl Loops {
    /// Shares `which` loop out to `workers`; of two loops the outer one by `schedule`.
    pub fn new(which: Which, schedule: Schedule, collect: Collect, workers: Workers) -> Self {
        Self { which, schedule, collect, workers, shared: Slots::default() }
    }
}

impl Find for Loops {
    fn find(&mut self, discs: &[Disc], _: &[bool], square: Square, _: Window, found: &mut Found) {
        let (n, schedule, radius) = (discs.len(), self.schedule, square.radius);
        let team = Team::Standing(&self.workers);
        // A list for each worker; in nested loops for each of each worker's team.
        let lists = Lists::take(found, team.count() * team.count());
        let (shared, locked, atomic) =
            (&self.shared, LockedCount::default(), SharedCount::default());
        let look = |list: usize, a: usize, partners: Range<usize>| {
            let (list, tests) = &mut *lists.of(list);
            *tests += partners.len() as u64;
            match self.collect {
                Collect::Own => look_for(discs, a, partners, radius, |hit| list.push(hit)),
                Collect::Locked => {
                    look_for(discs, a, partners, radius, |hit| append_locked(shared, &locked, hit))
                }
                Collect::Atomic => {
                    look_for(discs, a, partners, radius, |hit| append_atomic(shared, &atomic, hit))
                }
            }
        };
        match self.which {
            Which::Outer => outer(n, team, schedule, look),
            Which::Inner => inner(n, team, schedule, look),
            Which::Nested => nested(n, team, schedule, look),
        }
        lists.put_back(found);
        let count = locked.locked(|count| *count) + atomic.load();
        found.lists[0].extend(shared.first(count));
    }
}
