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
    // task 8.4: from the master to the workers
    if world.rank() != MASTER {
        return world.process_at_rank(MASTER).receive_vec().0;
    }
    request::scope(|scope| {
        let addressed = lists.iter().enumerate().map(|(worker, list)| (team.rank(worker), list));
        let requests: Vec<_> = addressed
            .filter(|(rank, _)| *rank != MASTER)
            .map(|(rank, list)| world.process_at_rank(rank).immediate_send(scope, &list[..]))
            .collect();
        requests.into_iter().for_each(|request| request.wait_without_status());
    });
    team.worker(MASTER).map_or_else(Vec::new, |own| lists[own].clone())
    // end 8.4
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
    // task 8.5: from the workers to the master
    if world.rank() != MASTER {
        world.process_at_rank(MASTER).send(own);
        return Vec::new();
    }
    let mut all = Vec::new();
    for worker in 0..team.workers {
        match team.rank(worker) {
            MASTER => all.extend_from_slice(own),
            rank => all.extend(world.process_at_rank(rank).receive_vec::<T>().0),
        }
    }
    all
    // end 8.5
}
