//! An observer that only counts.

use common::soft::{Observer, Statistics};

/// An observer that counts pair tests, for labs whose own observer is not complete yet.
#[derive(Clone, Default)]
pub struct Count {
    /// Number of reported pairs.
    pub tested: u64,
    /// Number of reported pairs within the cutoff whose positions differ.
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
