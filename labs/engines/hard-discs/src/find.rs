//! The interface of all searches, and their result.

use std::sync::{Mutex, MutexGuard};

use common::hard::Disc;
use crossbeam::utils::CachePadded;

use crate::collisions::Candidate;
use crate::geometry::{Square, Window};

/// The result of a search, and its costs.
#[derive(Debug, Default)]
pub struct Found {
    /// The candidates in any order, in a list for each worker that found candidates.
    pub lists: Vec<Vec<Candidate>>,
    /// Number of pairs that were tested.
    pub pair_tests: u64,
    /// Number of candidates to choose among.
    pub candidates: u64,
}

impl Found {
    /// Removes the candidates, keeps the memory, and makes sure that there are `lists` lists.
    pub fn clear(&mut self, lists: usize) {
        self.lists.iter_mut().for_each(Vec::clear);
        if self.lists.len() < lists {
            self.lists.resize_with(lists, Vec::new);
        }
    }
}

/// A search for the pairs that collide. Engines differ in their searches.
pub trait Find: Send {
    /// Returns the number of windows of equal length into which to divide the next step.
    ///
    /// The engine calls it at the start of every step. All finders but [`Planned`](crate::Planned)
    /// return 1.
    fn windows(&mut self, discs: &[Disc], square: Square) -> usize {
        let _ = (discs, square);
        1
    }

    /// Adds to `found` every pair of `free` discs that collides at a time in `window`.
    ///
    /// [`Collisions::pair_hit`](crate::Collisions::pair_hit) defines the collisions. A search must
    /// not miss a pair, nor find it twice. Whatever the window, the discs have their positions at
    /// the start of the *step*.
    fn find(
        &mut self,
        discs: &[Disc],
        free: &[bool],
        square: Square,
        window: Window,
        found: &mut Found,
    );
}

/// Candidates, and the number of pairs that were tested to find them.
pub(crate) type Tested = (Vec<Candidate>, u64);

/// The candidates that each of several workers finds.
///
/// Each list has its own cache lines, because a queue of single pairs locks a list for each pair.
pub(crate) struct Lists(Vec<CachePadded<Mutex<Tested>>>);

impl Lists {
    /// Makes `count` empty lists from the memory of the lists in `found`.
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
