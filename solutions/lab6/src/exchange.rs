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
