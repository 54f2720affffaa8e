//! Task 3.12: numbers that one thread writes and others read, without a lock.

use std::sync::atomic::Ordering;

use common::soft::Statistics;
use common_threads::Atomic;

/// The [`Statistics`] of a step, which one thread posts, once, and which others may look for.
///
/// `dmin` and `davg` are the bits of an `f64` ([`f64::to_bits`]).
// ANCHOR: notice
#[derive(Debug, Default)]
pub struct Notice {
    /// Bits of the least distance.
    pub dmin: Atomic,
    /// Bits of the sum of distances.
    pub davg: Atomic,
    /// Ordered pairs within the cutoff.
    pub navg: Atomic,
    /// Ordered pairs looked at.
    pub pair_tests: Atomic,
    /// The flag: 1 if the numbers are there, and 0 before.
    pub posted: Atomic,
}
// ANCHOR_END: notice

impl Notice {
    /// Writes the numbers, and raises the flag.
    ///
    /// Each [`Atomic::store`] has an [`Ordering`]. Take the weakest with which a thread that sees the flag
    /// raised also sees all numbers. If you prefer a fence, take [`common_threads::fence`], which the test sees.
    ///
    /// Book: chapter 3, *A flag instead of a lock*.
    pub fn post(&self, statistics: &Statistics) {
        // task 3.12: a notice is posted
        let Statistics { dmin, davg, navg, pair_tests } = *statistics;
        self.dmin.store(dmin.to_bits(), Ordering::Relaxed);
        self.davg.store(davg.to_bits(), Ordering::Relaxed);
        self.navg.store(navg, Ordering::Relaxed);
        self.pair_tests.store(pair_tests, Ordering::Relaxed);
        self.posted.store(1, Ordering::Release);
        // end 3.12
    }

    /// What was posted; `None` if that is not there yet. It looks at the flag once, and does not wait.
    ///
    /// Each [`Atomic::load`] has an [`Ordering`], too: again the weakest that will do. What is returned is whole: the
    /// numbers that were posted, and none from before.
    ///
    /// Book: chapter 3, *A flag instead of a lock*.
    pub fn read(&self) -> Option<Statistics> {
        // task 3.12b: a notice is read
        (self.posted.load(Ordering::Acquire) == 1).then(|| Statistics {
            dmin: f64::from_bits(self.dmin.load(Ordering::Relaxed)),
            davg: f64::from_bits(self.davg.load(Ordering::Relaxed)),
            navg: self.navg.load(Ordering::Relaxed),
            pair_tests: self.pair_tests.load(Ordering::Relaxed),
        })
        // end 3.12b
    }
}
