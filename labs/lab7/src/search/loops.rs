//! All pairs, and the two loops over them shared out.

use std::ops::Range;

use common::hard::Disc;

use super::{Find, Found, Lists};
use crate::{Schedule, Square, Team, Window, Workers, look_along};

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

/// Which of the two loops is shared out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Which {
    /// The loop over a: one fork and join a step. Iterations are of unequal length, since disc a
    /// has n − 1 − a discs above it.
    Outer,
    /// The loop over b: equal iterations, but n forks and joins a step.
    Inner,
    /// Both: each worker of the outer loop starts a team of its own for every inner loop.
    Nested {
        /// How the inner loop is dealt out.
        inner: Schedule,
    },
}

/// All pairs a < b, by several threads.
pub struct Loops {
    /// Which loop is shared out.
    pub which: Which,
    /// How; of two loops the outer one.
    pub schedule: Schedule,
    /// To whom.
    pub workers: Workers,
}

impl Find for Loops {
    fn find(&mut self, discs: &[Disc], _: &[bool], square: Square, _: Window, found: &mut Found) {
        let (n, schedule) = (discs.len(), self.schedule);
        let team = Team::Standing(&self.workers);
        // A list for each worker; in nested loops for each of each worker's team.
        let lists = Lists::take(found, team.count() * team.count());
        let look = |list: usize, a: usize, partners: Range<usize>| {
            let (list, tests) = &mut *lists.of(list);
            *tests += partners.len() as u64;
            look_along(discs, a, partners, square.radius, list);
        };

        match self.which {
            Which::Outer => team.run(n, schedule, |worker, part| {
                for a in part {
                    look(worker, a, a + 1..n);
                }
            }),
            Which::Inner => {
                for a in 0..n {
                    team.run(n - a - 1, schedule, |worker, part| {
                        look(worker, a, a + 1 + part.start..a + 1 + part.end);
                    });
                }
            }
            Which::Nested { inner } => {
                let inner_team = Team::Fresh(team.count());
                team.run(n, schedule, |worker, part| {
                    for a in part {
                        inner_team.run(n - a - 1, inner, |member, part| {
                            let list = worker * team.count() + member;
                            look(list, a, a + 1 + part.start..a + 1 + part.end);
                        });
                    }
                });
            }
        }
        lists.put_back(found);
    }
}
