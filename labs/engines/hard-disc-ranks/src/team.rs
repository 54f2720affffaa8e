//! The team of a master and its workers, and messages between them.

use mpi::Rank;
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;

/// The rank that sends, collects and decides.
pub const MASTER: Rank = 0;

/// The workers under a master, numbered from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Team {
    /// Number of workers, at least 1.
    pub workers: usize,
    /// Whether the master is worker 0 as well. If not, worker k is rank k + 1.
    pub master_works: bool,
}

impl Team {
    /// Returns the team of a job of `ranks` ranks. A master without other ranks is a worker too.
    pub fn new(ranks: usize, master_works: bool) -> Self {
        let master_works = master_works || ranks == 1;
        Self { workers: ranks - usize::from(!master_works), master_works }
    }

    /// Returns the rank of a worker.
    pub fn rank(&self, worker: usize) -> Rank {
        (worker + usize::from(!self.master_works)) as Rank
    }

    /// Returns the worker number of a rank; `None` for a master that does not work.
    pub fn worker(&self, rank: Rank) -> Option<usize> {
        (rank as usize).checked_sub(usize::from(!self.master_works))
    }
}

/// Messages from the master to the workers, and back. All ranks call each function together.
pub trait Messages: Sized + 'static {
    /// Sends `lists[k]` to worker k, and returns this worker's list.
    ///
    /// Only the master's `lists` matter. A master that does not work gets an empty list.
    fn hand_out<W: Equivalence + Clone>(
        world: &SimpleCommunicator,
        team: Team,
        lists: &[Vec<W>],
    ) -> Vec<W>;

    /// On the master, returns the lists of all workers, concatenated in the order of workers.
    ///
    /// The result is empty on other ranks.
    fn collect<W: Equivalence + Clone>(world: &SimpleCommunicator, team: Team, own: &[W])
    -> Vec<W>;
}
