//! Tasks 6.3 and 6.4: messages from rank to rank, without the root.

use common_mpi::displacements;
use mpi::datatype::{Partition, PartitionMut};
use mpi::request;
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;
use mpi::{Count, Rank};

/// Exchanges lists with other ranks, and calls `work` once while the lists travel.
///
/// - `outgoing` contains the other ranks, each with the list for it. These ranks call this function
///   at the same time: if rank a is in rank b's `outgoing`, b is in a's. `outgoing` and its lists
///   may be empty.
/// - Return the lists received from the same ranks, in the order of `outgoing`, and the result of
///   `work`.
///
/// A blocking send may wait until the other rank receives. If all ranks send first and receive
/// afterwards, all of them may wait forever. They do not wait while messages are short, because the
/// library buffers short messages. Such a program works until the day it gets more particles. So do
/// not block here: start all receives and all sends ([`Source::immediate_receive_into`],
/// [`Destination::immediate_send`]), and only then wait for them
/// ([`wait_without_status`](request::Request::wait_without_status)).
///
/// A receive needs a buffer of the right length, so there are two exchanges:
///
/// 1. Exchange the lengths of the lists, one `u64` in each direction, and wait.
/// 2. Start the exchange of the items, call `work`, and wait. (Both sides now know which lists are
///    empty. You may send these or leave them out.)
///
/// Until a request has been waited for, its buffer belongs to the message. A [`request::scope`]
/// enforces this, so make the requests in a scope.
///
/// Book: chapter 6, *Both ways at once*.
pub fn exchange_beside<T, R>(
    world: &SimpleCommunicator,
    outgoing: &[(Rank, Vec<T>)],
    work: impl FnOnce() -> R,
) -> (Vec<Vec<T>>, R)
where
    T: Equivalence + Default + Clone,
{
    todo!("task 6.3: messages both ways at once")
}

/// Sends `lists[k]` to rank k, for every k, and returns the items that all ranks sent to this rank.
///
/// There is one list for each rank, including this rank. Most lists are empty. The result is
/// the received lists joined end to end, in the order of ranks.
///
/// Two collective operations are needed. First exchange the counts
/// ([`CommunicatorCollectives::all_to_all_into`]). Then exchange the items
/// ([`CommunicatorCollectives::all_to_all_varcount_into`]), from a [`Partition`] into a
/// [`PartitionMut`]. [`displacements`] returns the index at which each list begins.
///
/// All ranks call this together, even ranks whose lists are all empty.
///
/// Book: chapter 6, *Alltoallv*.
pub fn exchange_all<T>(world: &SimpleCommunicator, lists: &[Vec<T>]) -> Vec<T>
where
    T: Equivalence + Default + Clone,
{
    todo!("task 6.4: Alltoallv")
}
