//! Searches that test all pairs: with one thread, and with several.

use std::marker::PhantomData;
use std::ops::Range;

use common::hard::Disc;
use workers::Workers;

use crate::collisions::Collisions;
use crate::find::{Find, Found, Lists};
use crate::geometry::{Square, Window};
use crate::pairs::{look_along, look_for};
use crate::parallel_loops::{ParallelLoops, Which};
use crate::threads::{LockedCount, Schedule, SharedCount, Slots, Team};

/// A search that tests all pairs a < b with one thread.
pub struct AllPairs<C>(PhantomData<C>);

impl<C> Default for AllPairs<C> {
    fn default() -> Self {
        Self(PhantomData)
    }
}

impl<C: Collisions> Find for AllPairs<C> {
    fn find(&mut self, discs: &[Disc], _: &[bool], square: Square, _: Window, found: &mut Found) {
        let n = discs.len();
        let list = found.lists.first_mut().expect("Found::clear was called, and made a list");
        for a in 0..n {
            look_along::<C>(discs, a, a + 1..n, square.radius, list);
            found.pair_tests += (n - a - 1) as u64;
        }
    }
}

/// The place where workers store the candidates that they find.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Collect {
    /// Each worker has its own list.
    Own,
    /// All workers append to one array. A lock protects its counter.
    Locked,
    /// All workers append to one array. Its counter is atomic.
    Atomic,
}

/// A search that tests all pairs a < b with several threads.
pub struct Loops<C> {
    rules: PhantomData<C>,
    which: Which,
    schedule: Schedule,
    collect: Collect,
    workers: Workers,
    shared: Slots,
}

impl<C> Loops<C> {
    /// Divides `which` loop among `workers`; if both loops are divided, `schedule` applies to the
    /// outer loop.
    pub fn new(which: Which, schedule: Schedule, collect: Collect, workers: Workers) -> Self {
        Self { rules: PhantomData, which, schedule, collect, workers, shared: Slots::default() }
    }
}

impl<C: Collisions + ParallelLoops> Find for Loops<C> {
    fn find(&mut self, discs: &[Disc], _: &[bool], square: Square, _: Window, found: &mut Found) {
        let radius = square.radius;
        let team = Team::Standing(&self.workers);
        // There is a list for each worker; in nested loops there is a list for each member of each
        // worker's team.
        let lists = Lists::take(found, team.count() * team.count());
        let shared = &self.shared;
        let locked = LockedCount::default();
        let atomic = SharedCount::default();
        let look = |list: usize, a: usize, partners: Range<usize>| {
            let (list, tests) = &mut *lists.of(list);
            *tests += partners.len() as u64;
            match self.collect {
                Collect::Own => look_for::<C>(discs, a, partners, radius, |hit| list.push(hit)),
                Collect::Locked => look_for::<C>(discs, a, partners, radius, |hit| {
                    C::append_locked(shared, &locked, hit)
                }),
                Collect::Atomic => look_for::<C>(discs, a, partners, radius, |hit| {
                    C::append_atomic(shared, &atomic, hit)
                }),
            }
        };
        C::all_pairs(self.which, discs.len(), team, self.schedule, look);
        lists.write_back(found);
        let count = locked.locked(|count| *count) + atomic.load();
        found.lists[0].extend(shared.first(count));
    }
}
