//! Task 1.4: how close the particles come.

use common::soft::{CUTOFF, Observer, Statistics};

/// The observer that collects the statistics of a step.
#[derive(Clone, Copy, Debug, Default)]
pub struct Tally(Statistics);

impl Observer for Tally {
    #[inline]
    fn tested(&mut self, pairs: u64) {
        self.0.pair_tests += pairs;
    }

    /// Adds an ordered pair at squared distance `r2` ≤ cutoff² to the statistics of the step.
    ///
    /// The statistics are the least distance `dmin`, the sum of distances `davg` and the number of
    /// pairs `navg`. Distances are in units of the cutoff: the square root of
    /// `r2 / (CUTOFF * CUTOFF)`.
    ///
    /// A pair at distance 0 does not count. It is a particle with itself, or two particles at the
    /// same position, and there is no force between them.
    ///
    /// Book: chapter 1, *Statistics*.
    #[inline]
    fn seen(&mut self, r2: f64) {
        todo!("task 1.4: statistics")
    }

    fn merge(&mut self, other: &Self) {
        self.0.dmin = self.0.dmin.min(other.0.dmin);
        self.0.davg += other.0.davg;
        self.0.navg += other.0.navg;
        self.0.pair_tests += other.0.pair_tests;
    }

    fn statistics(&self) -> Option<Statistics> {
        Some(self.0)
    }
}
