//! Which rank does what under a master, and messages between master and workers.

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
    /// The team of a job of `ranks` ranks. A master that is alone has to work.
    pub fn new(ranks: usize, master_works: bool) -> Self {
        let master_works = master_works || ranks == 1;
        Self { workers: ranks - usize::from(!master_works), master_works }
    }

    /// The rank of a worker.
    pub fn rank(&self, worker: usize) -> Rank {
        (worker + usize::from(!self.master_works)) as Rank
    }

    /// The worker that a rank is; none for a master that does not work.
    pub fn worker(&self, rank: Rank) -> Option<usize> {
        (rank as usize).checked_sub(usize::from(!self.master_works))
    }
}

/// How lists travel from the master to the workers, and back. All ranks call each function together.
pub trait Messages: Sized + 'static {
    /// Sends each worker its list, and returns it there: `lists[k]` is for worker k. `lists` matters on the master
    /// only. A master that does not work gets an empty list.
    fn hand_out<W: Equivalence + Clone>(
        world: &SimpleCommunicator,
        team: Team,
        lists: &[Vec<W>],
    ) -> Vec<W>;

    /// Returns the lists of all workers at the master, one behind the other in the order of workers; elsewhere
    /// nothing.
    fn collect<W: Equivalence + Clone>(world: &SimpleCommunicator, team: Team, own: &[W])
    -> Vec<W>;
}
