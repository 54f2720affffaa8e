//! Messages from rank to rank, past the root.

use mpi::Rank;
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;

/// How messages travel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Route {
    /// Non-blocking, to the two neighbours; to other ranks only if a particle goes there.
    Neighbours,
    /// By collective operations of all ranks.
    AllRanks,
}

/// How lists get from rank to rank.
pub trait Messages {
    /// Sends each of the `outgoing` lists to its rank, receives a list from each of these same ranks, and calls `work`
    /// once while the lists travel. Returns the lists received, in the order of `outgoing`, and what `work` returned.
    fn exchange_beside<T, R>(
        world: &SimpleCommunicator,
        outgoing: &[(Rank, Vec<T>)],
        work: impl FnOnce() -> R,
    ) -> (Vec<Vec<T>>, R)
    where
        T: Equivalence + Default + Clone;

    /// Sends `lists[k]` to rank k, for every k. Returns what all ranks sent to this one, in the order of ranks.
    ///
    /// All ranks call it together.
    fn exchange_all<T>(world: &SimpleCommunicator, lists: &[Vec<T>]) -> Vec<T>
    where
        T: Equivalence + Default + Clone;
}
