//! Tasks 8.4 and 8.5: from the master to the workers, and back.

use hard_disc_ranks::{MASTER, Team};
use mpi::request;
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;

/// Sends each worker its list: `lists[k]` is for worker k, and the return value there. `lists`
/// matters on the master only. A master that does not work gets an empty list.
///
/// A worker does not know how long its list will be. It can ask the message itself before it
/// makes a buffer: [`Source::receive_vec`] does.
///
/// The master starts all sends ([`Destination::immediate_send`], within a [`request::scope`]; see
/// chapter 6, *Both ways at once*) and then waits for all of them. The report sends and waits, one worker
/// after the other, and a worker that is not ready yet keeps the next ones waiting.
///
/// A master that works sends nothing to itself and keeps its own list: a message to its own rank that
/// is too long to be copied aside waits for a receive that is never reached.
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

/// Collects the workers' lists at the master: returns there the lists of all workers, one behind
/// the other in the order of workers; elsewhere it returns nothing. A master that does not work has
/// no list.
///
/// Again lists may be of any length. Receive from worker after worker, not in the order in which
/// messages arrive: then the result is the same in every run.
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
