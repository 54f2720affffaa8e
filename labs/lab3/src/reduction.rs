//! Task 3.2: one sum by several threads, in three ways.

use common::soft::{Observer, Statistics};
use common_threads::Word;
use parking_lot::Mutex;
use rayon::prelude::*;

/// Adds up `parts` in one total, which a lock protects.
///
/// The parts are divided among Rayon's threads. A thread holds the lock while it adds a part to the
/// total.
///
/// Book: chapter 3, *A reduction, three ways*.
pub fn under_a_lock<O: Observer>(parts: &[O]) -> O {
    todo!("task 3.2: a reduction under one lock")
}

/// [`Statistics`] to which several threads add at the same time.
///
/// `dmin` and `davg` are the bits of an `f64` ([`f64::to_bits`]). For numbers that are not
/// negative, the order of the bits is the order of the numbers.
#[derive(Debug)]
pub struct AtomicStatistics {
    /// The bits of the least distance.
    pub dmin: Word,
    /// The bits of the sum of distances.
    pub davg: Word,
    /// The number of ordered pairs within the cutoff.
    pub navg: Word,
    /// The number of ordered pairs tested.
    pub pair_tests: Word,
}

impl AtomicStatistics {
    /// Adds the counts and the sum of distances of `part`, and keeps the lesser of the two least
    /// distances.
    ///
    /// No atomic operation adds to an `f64`. [`Word::compare_exchange`] fails if another thread has
    /// changed the sum since you read it.
    ///
    /// Book: chapter 3, *A reduction, three ways*.
    pub fn add(&self, part: &Statistics) {
        todo!("task 3.2b: a reduction with atomics")
    }

    /// Returns the sum of all parts added so far.
    pub fn sum(&self) -> Statistics {
        Statistics {
            dmin: f64::from_bits(self.dmin.load()),
            davg: f64::from_bits(self.davg.load()),
            navg: self.navg.load(),
            pair_tests: self.pair_tests.load(),
        }
    }
}

impl Default for AtomicStatistics {
    fn default() -> Self {
        let Statistics { dmin, davg, navg, pair_tests } = Statistics::default();
        Self {
            dmin: Word::new(dmin.to_bits()),
            davg: Word::new(davg.to_bits()),
            navg: Word::new(navg),
            pair_tests: Word::new(pair_tests),
        }
    }
}

/// Adds up `parts` with [`AtomicStatistics`]. The parts are divided among Rayon's threads.
pub fn with_atomics(parts: &[Statistics]) -> Statistics {
    let total = AtomicStatistics::default();
    parts.par_iter().for_each(|part| total.add(part));
    total.sum()
}

/// The number of parts in a block. One thread adds up a whole block.
pub const BLOCK: usize = 64;

/// Adds up `parts` without a lock. The result has the same bits on any number of threads.
///
/// The parts are cut into blocks of [`BLOCK`] parts; the last block may be shorter. The blocks are
/// divided among Rayon's threads. Each block is summed from zero, in the order of its parts.
/// Finally, one thread adds up the sums of the blocks, in the order of the blocks.
///
/// Book: chapter 3, *A reduction, three ways*.
pub fn in_order<O: Observer>(parts: &[O]) -> O {
    todo!("task 3.2c: a reduction in a fixed order")
}
