//! The search: what all ways to find pairs have in common.

use std::sync::{Mutex, MutexGuard};

use common::hard::Disc;
use crossbeam::utils::CachePadded;
use workers::Workers;

use crate::collisions::Candidate;
use crate::geometry::{Square, Window};

/// What was found, and what it took.
#[derive(Debug, Default)]
pub struct Found {
    /// The candidates, in lists of any lengths and orders: one for each worker that found some.
    pub lists: Vec<Vec<Candidate>>,
    /// How many pairs were tested.
    pub pair_tests: u64,
    /// How many candidates there were to choose among.
    pub candidates: u64,
}

impl Found {
    /// Forgets the candidates, keeps the memory, and makes sure that there are `lists` lists.
    pub fn clear(&mut self, lists: usize) {
        self.lists.iter_mut().for_each(Vec::clear);
        if self.lists.len() < lists {
            self.lists.resize_with(lists, Vec::new);
        }
    }
}

/// A way to find the pairs that collide: what engines differ in.
pub trait Find: Send {
    /// The workers on one of which the whole step is to run. What a thread hands over to others of its own
    /// pool costs less than what comes from outside; it shows where a step has many short loops.
    fn home(&self) -> Workers {
        Workers::One
    }

    /// Called at the start of every step: into how many windows of equal length the finder wants
    /// it cut. All but [`Planned`](crate::Planned) want one.
    fn windows(&mut self, discs: &[Disc], square: Square) -> usize {
        let _ = (discs, square);
        1
    }

    /// Adds to `found` every pair of discs that are both `free` and that collide
    /// ([`Collisions::pair_hit`](crate::Collisions::pair_hit)) at a time in `window`. It must not miss one, nor find one twice.
    ///
    /// Discs stand where they are at the start of the *step*, whatever the window.
    fn find(
        &mut self,
        discs: &[Disc],
        free: &[bool],
        square: Square,
        window: Window,
        found: &mut Found,
    );
}

/// Candidates, and how many pairs were tested to find them.
pub(crate) type Tested = (Vec<Candidate>, u64);

/// What each of several workers finds.
///
/// On cache lines of their own: the queue of single pairs takes a list for each of them.
pub(crate) struct Lists(Vec<CachePadded<Mutex<Tested>>>);

impl Lists {
    /// `count` empty lists, with the memory of those in `found`.
    pub(crate) fn take(found: &mut Found, count: usize) -> Self {
        found.clear(count);
        Self(found.lists.drain(..).map(|list| CachePadded::new(Mutex::new((list, 0)))).collect())
    }

    pub(crate) fn of(&self, worker: usize) -> MutexGuard<'_, Tested> {
        self.0[worker].lock().expect("no worker panics in a search")
    }

    pub(crate) fn write_back(self, found: &mut Found) {
        for list in self.0 {
            let (list, tests) = list.into_inner().into_inner().expect("as above");
            found.lists.push(list);
            found.pair_tests += tests;
        }
    }
}
