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
    // task 6.3: messages both ways at once
    let lengths: Vec<u64> = outgoing.iter().map(|(_, list)| list.len() as u64).collect();
    let mut counts = vec![0_u64; outgoing.len()];
    request::scope(|scope| {
        let mut requests = Vec::new();
        for (((rank, _), length), count) in outgoing.iter().zip(&lengths).zip(&mut counts) {
            let other = world.process_at_rank(*rank);
            requests.push(other.immediate_receive_into(scope, count));
            requests.push(other.immediate_send(scope, length));
        }
        requests.into_iter().for_each(|request| request.wait_without_status());
    });
    let mut incoming: Vec<Vec<T>> =
        counts.iter().map(|&count| vec![T::default(); count as usize]).collect();
    let result = request::scope(|scope| {
        let mut requests = Vec::new();
        for ((rank, list), buffer) in outgoing.iter().zip(&mut incoming) {
            let other = world.process_at_rank(*rank);
            requests.push(other.immediate_receive_into(scope, &mut buffer[..]));
            requests.push(other.immediate_send(scope, &list[..]));
        }
        let result = work();
        requests.into_iter().for_each(|request| request.wait_without_status());
        result
    });
    (incoming, result)
    // end 6.3
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
    // task 6.4: Alltoallv
    let counts: Vec<Count> = lists.iter().map(|list| list.len() as Count).collect();
    let mut incoming_counts: Vec<Count> = vec![0; counts.len()];
    world.all_to_all_into(&counts[..], &mut incoming_counts[..]);
    let outgoing = lists.concat();
    let total = incoming_counts.iter().map(|count| *count as usize).sum();
    let mut incoming = vec![T::default(); total];
    let from = Partition::new(&outgoing[..], &counts[..], displacements(&counts));
    let starts = displacements(&incoming_counts);
    let mut into = PartitionMut::new(&mut incoming[..], &incoming_counts[..], starts);
    world.all_to_all_varcount_into(&from, &mut into);
    incoming
    // end 6.4
}
