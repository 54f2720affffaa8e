//! Task 8.7: a master that decides, and workers that search.

use hard_disc_ranks::{Dealing, MasterWorkers};
use mpi::traits::*;
use solution7::{Candidate, resolve, take_in_order};

use crate::collided::update;
use crate::deal::deal_out;

/// Decides which of all workers' `candidates` happen, and moves the discs.
///
/// Only the master calls this. Take the candidates that happen, with lab 7's [`take_in_order`].
/// Advance the discs that are still free in a straight line. Carry out the collisions that were
/// taken, with lab 7's [`resolve`].
///
/// `engine.taken` contains the collisions of the previous step: replace them. `engine.tally.taken`
/// counts the new collisions.
///
/// Book: chapter 8, *A step of master and workers*.
fn decide<T: Dealing>(engine: &mut MasterWorkers<T>, mut candidates: Vec<Candidate>) {
    engine.tally.candidates += candidates.len() as u64;
    let mut free = vec![true; engine.discs.len()];
    todo!("task 8.7b: the master decides")
}

/// Computes one step.
///
/// 1. In the first step after a scene was loaded, `engine.deal` is `None`. In this case, deal the
///    pairs to the workers of the team ([`deal_out`]).
/// 2. The master makes its lists ([`MasterWorkers::lists`]). The other ranks have no lists. All
///    ranks call [`MasterWorkers::send`], which calls and counts [`hand_out`], and returns the
///    discs that arrived.
/// 3. A worker that is not the master updates the discs of its blocks ([`update`],
///    [`Deal::blocks`](hard_disc_ranks::Deal::blocks)). It must move them if this is not the first
///    step and workers keep their blocks. The master's discs are up to date.
/// 4. Each worker, including a master that works, finds candidates ([`MasterWorkers::find`]).
/// 5. All ranks call [`MasterWorkers::receive`], which calls and counts [`collect`]. Then the master
///    decides ([`decide`]).
///
/// [`Team::worker`] returns the worker number of a rank. The methods that change `engine` cannot
/// borrow the deal from it at the same time: [take](Option::take) the deal out, and put it back at
/// the end. All ranks call this together.
///
/// Book: chapter 8, *A step of master and workers*.
///
/// [`hand_out`]: crate::hand_out
/// [`collect`]: crate::collect
/// [`Team::worker`]: hard_disc_ranks::Team::worker
pub(crate) fn step<T: Dealing>(engine: &mut MasterWorkers<T>) {
    todo!("task 8.7: one step of master and workers")
}
