//! What each of several workers finds.

use std::sync::{Mutex, MutexGuard};

use crossbeam::utils::CachePadded;

use crate::candidate::Candidate;
use crate::find::Found;

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
