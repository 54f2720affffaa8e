//! An observer that only counts.

use common::soft::{Observer, Statistics};

/// Counts the pairs that were looked at, whatever else of an observer is not written yet.
#[derive(Clone, Default)]
pub struct Count {
    /// How many it was told of.
    pub tested: u64,
    /// How many of these are within the cutoff, and at two positions.
    pub seen: u64,
}

impl Observer for Count {
    fn tested(&mut self, pairs: u64) {
        self.tested += pairs;
    }

    fn seen(&mut self, r2: f64) {
        self.seen += u64::from(r2 > 0.0);
    }

    fn merge(&mut self, other: &Self) {
        self.tested += other.tested;
        self.seen += other.seen;
    }

    fn statistics(&self) -> Option<Statistics> {
        Some(Statistics { pair_tests: self.tested, navg: self.seen, ..Statistics::default() })
    }
}
