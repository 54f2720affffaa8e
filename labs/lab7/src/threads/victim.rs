//! Another worker's deque.

use std::ops::Range;
use std::sync::atomic::{AtomicUsize, Ordering};

use crossbeam::deque::{Steal, Stealer, Worker};

/// A worker's own parts of a loop. `push` puts one on top, `pop` takes the top one.
pub type Deque = Worker<Range<usize>>;

/// Another worker's deque, at the end that one may steal from: the bottom.
///
/// A test can have steals fail as they do when another thread steals at the same moment
/// ([`Victim::crowded`]). Without a test that costs one look at a zero.
pub struct Victim {
    stealer: Stealer<Range<usize>>,
    refusals: AtomicUsize,
}

impl Victim {
    /// The other end of `deque`.
    pub fn of(deque: &Deque) -> Self {
        Self::crowded(deque, 0)
    }

    /// The same, which answers [`Steal::Retry`] so many times before it says what there is.
    pub fn crowded(deque: &Deque, times: usize) -> Self {
        Self { stealer: deque.stealer(), refusals: AtomicUsize::new(times) }
    }

    /// Tries to take the part at the bottom: [`Steal::Success`] with the part, [`Steal::Empty`] if
    /// there is none, [`Steal::Retry`] if another thread came between, and nothing is known.
    pub fn steal(&self) -> Steal<Range<usize>> {
        let less = |left: usize| left.checked_sub(1);
        match self.refusals.fetch_update(Ordering::Relaxed, Ordering::Relaxed, less) {
            Ok(_) => Steal::Retry,
            Err(_) => self.stealer.steal(),
        }
    }
}
