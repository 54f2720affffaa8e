//! The interface for messages that do not pass through the root.

use mpi::Rank;
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;

/// The way that messages travel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Route {
    /// Non-blocking messages to the two neighbours, and to other ranks only if a particle goes
    /// there.
    Neighbours,
    /// Collective operations of all ranks.
    AllRanks,
}

/// Exchanges of lists between ranks.
pub trait Messages {
    /// Sends each of the `outgoing` lists to its rank, and receives a list from each of the same
    /// ranks.
    ///
    /// Calls `work` once while the lists travel. Returns the received lists, in the order of
    /// `outgoing`, and the result of `work`.
    fn exchange_beside<T, R>(
        world: &SimpleCommunicator,
        outgoing: &[(Rank, Vec<T>)],
        work: impl FnOnce() -> R,
    ) -> (Vec<Vec<T>>, R)
    where
        T: Equivalence + Default + Clone;

    /// Sends `lists[k]` to rank k, for every k. Returns the items that were sent to this rank, in
    /// the order of ranks.
    ///
    /// All ranks call this function together.
    fn exchange_all<T>(world: &SimpleCommunicator, lists: &[Vec<T>]) -> Vec<T>
    where
        T: Equivalence + Default + Clone;
}
