//! Task 3.12: numbers that one thread writes and others read, without a lock.

use std::sync::atomic::Ordering;

use common::soft::Statistics;
use common_threads::Atomic;

/// The [`Statistics`] of a step, which one thread posts once and other threads may read.
///
/// `dmin` and `davg` are the bits of an `f64` ([`f64::to_bits`]).
// ANCHOR: notice
#[derive(Debug, Default)]
pub struct Notice {
    /// The bits of the least distance.
    pub dmin: Atomic,
    /// The bits of the sum of distances.
    pub davg: Atomic,
    /// The number of ordered pairs within the cutoff.
    pub navg: Atomic,
    /// The number of ordered pairs tested.
    pub pair_tests: Atomic,
    /// The flag: 1 if the numbers have been posted, 0 before.
    pub posted: Atomic,
}
// ANCHOR_END: notice

impl Notice {
    /// Writes the numbers, then raises the flag.
    ///
    /// Each [`Atomic::store`] takes an [`Ordering`]. Choose the weakest orderings that guarantee
    /// this: a thread that sees the flag raised also sees all numbers. If you prefer a fence, call
    /// [`common_threads::fence`], which the test can observe.
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

    /// Returns the posted numbers, or `None` if they have not been posted yet.
    ///
    /// Read the flag once, and do not wait for it. Each [`Atomic::load`] takes an [`Ordering`].
    /// Again, choose the weakest orderings that suffice. All numbers in the result must be the
    /// posted numbers, never older values.
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
