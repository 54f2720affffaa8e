//! What engines count.

use common_mpi::Traffic;
use hard_discs::{Candidate, Hit};
use mpi::collective::SystemOperation;
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;

/// What one rank has counted since a scene was loaded.
#[derive(Clone, Copy, Debug, Default)]
pub struct Tally {
    /// Pairs looked at.
    pub pair_tests: u64,
    /// Candidates found.
    pub candidates: u64,
    pairs: u64,
    walls: u64,
}

impl Tally {
    /// Collisions that happened.
    pub fn taken(&mut self, taken: &[Candidate]) {
        let pairs = taken.iter().filter(|c| matches!(c.hit, Hit::Pair(..))).count();
        self.pairs += pairs as u64;
        self.walls += (taken.len() - pairs) as u64;
    }

    /// The counters of all ranks together, in the words of lab 7, and what they have sent. All
    /// ranks call it together; only the root gets an answer that means anything.
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
