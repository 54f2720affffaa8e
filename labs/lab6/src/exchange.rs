//! Tasks 6.3 and 6.4: messages from rank to rank, past the root.

use common_mpi::displacements;
use mpi::datatype::{Partition, PartitionMut};
use mpi::request;
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;
use mpi::{Count, Rank};

/// Sends each of the `outgoing` lists to its rank, receives a list from each of these same ranks,
/// and calls `work` once while the lists travel. Returns the lists received, in the order of
/// `outgoing`, and what `work` returned.
///
/// The other side does the same: if rank a is in b's list, b is in a's. Lists may be empty, and so
/// may `outgoing` be.
///
/// A blocking send may wait until the other rank receives. If all ranks send first and receive
/// afterwards, all may wait for ever. With short messages, which the library keeps aside, they do
/// not, and the program works until the day it gets more particles. So nothing blocks here: start
/// all receives and all sends ([`Source::immediate_receive_into`], [`Destination::immediate_send`]),
/// and only then wait for them ([`wait_without_status`](request::Request::wait_without_status)).
///
/// A receive needs a buffer of the right length. So first exchange how many items there will be, a
/// `u64` each way, and wait; then exchange the items. `work` comes between the start of the second
/// exchange and the wait for it. (By then both sides know which lists are empty. Whether these are sent
/// is up to you.) Until a request has been waited for, its buffer belongs to the message: requests live in a
/// [`request::scope`], which sees to it.
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

/// Sends `lists[k]` to rank k, for every k, and returns what all ranks sent to this one, one list
/// behind the other in the order of ranks.
///
/// There are as many lists as ranks, the one for this rank itself among them; most are empty. It
/// takes two collective operations: the counts ([`CommunicatorCollectives::all_to_all_into`]), then
/// the items ([`CommunicatorCollectives::all_to_all_varcount_into`]) from a [`Partition`] into a
/// [`PartitionMut`]. [`displacements`] says where each list begins.
///
/// All ranks call it together, also those whose lists are all empty.
///
/// Book: chapter 6, *Alltoallv*.
pub fn exchange_all<T>(world: &SimpleCommunicator, lists: &[Vec<T>]) -> Vec<T>
where
    T: Equivalence + Default + Clone,
{
    todo!("task 6.4: Alltoallv")
}
