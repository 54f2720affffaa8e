//! The counters of the engines.

use common_mpi::Traffic;
use hard_discs::{Candidate, Hit};
use mpi::collective::SystemOperation;
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;

/// The counters of a rank since a scene was loaded.
#[derive(Clone, Copy, Debug, Default)]
pub struct Tally {
    /// Number of pairs that were tested.
    pub pair_tests: u64,
    /// Number of candidates that were found.
    pub candidates: u64,
    pairs: u64,
    walls: u64,
}

impl Tally {
    /// Counts the collisions in `taken`, which happened.
    pub fn taken(&mut self, taken: &[Candidate]) {
        let pairs = taken.iter().filter(|c| matches!(c.hit, Hit::Pair(..))).count();
        self.pairs += pairs as u64;
        self.walls += (taken.len() - pairs) as u64;
    }

    /// Returns the sum of each counter over all ranks, under the name that lab 7 uses.
    ///
    /// Also returns the pair tests of the busiest rank, and the messages and bytes per step
    /// ([`Traffic::report`]). All ranks call this function together; only the root's result is
    /// valid.
    pub fn report(
        &self,
        world: &SimpleCommunicator,
        traffic: &Traffic,
    ) -> Vec<(&'static str, f64)> {
        let own = [self.pair_tests, self.candidates, self.pairs, self.walls];
        let mut all = [0_u64; 4];
        let mut most = [0_u64; 4];
        world.all_reduce_into(&own[..], &mut all[..], SystemOperation::sum());
        world.all_reduce_into(&own[..], &mut most[..], SystemOperation::max());
        let mut counters = vec![
            ("pair tests", all[0] as f64),
            ("pair tests, busiest rank", most[0] as f64),
            ("candidates", all[1] as f64),
            ("pair collisions", all[2] as f64),
            ("wall collisions", all[3] as f64),
        ];
        counters.extend(traffic.report(world));
        counters
    }
}
