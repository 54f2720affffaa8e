//! Tasks 8.4 and 8.5: from the master to the workers, and back.

use hard_disc_ranks::{MASTER, Team};
use mpi::request;
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;

/// Sends each worker its list: worker k returns `lists[k]`.
///
/// Only the master reads `lists`. A master that does not work returns an empty list.
///
/// - A worker does not know the length of its list, so it must get the length from the message
///   before it makes a buffer. [`Source::receive_vec`] does this.
/// - The master starts all sends ([`Destination::immediate_send`], within a [`request::scope`]; see
///   chapter 6, *Both ways at once*), and then waits for all of them. The report instead waits
///   after each send, so a worker that is not ready delays all later workers.
/// - A master that works keeps its own list, and sends nothing to itself. A message to its own rank
///   that is too long for the library's buffer would wait for a receive that is never reached.
///
/// All ranks call it together.
///
/// Book: chapter 8, *From the master and back*.
pub fn hand_out<T>(world: &SimpleCommunicator, team: Team, lists: &[Vec<T>]) -> Vec<T>
where
    T: Equivalence + Clone,
{
    todo!("task 8.4: from the master to the workers")
}

/// Collects the workers' lists at the master, which returns all items in the order of workers.
///
/// All other ranks return an empty list. A master that does not work has no list.
///
/// Again, the lists may have any length. Receive from the workers in order of their numbers, not in
/// the order in which messages arrive. The result is then the same in every run.
///
/// All ranks call it together.
///
/// Book: chapter 8, *From the master and back*.
pub fn collect<T>(world: &SimpleCommunicator, team: Team, own: &[T]) -> Vec<T>
where
    T: Equivalence + Clone,
{
    todo!("task 8.5: from the workers to the master")
}
