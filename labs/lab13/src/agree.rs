//! Task 13.6: all ranks agree that lists have expired.

use common::soft::CUTOFF;
use mpi::collective::SystemOperation;
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;

/// Whether any rank, and therefore every rank, must make new lists before it computes forces.
///
/// - `list_has_expired`: whether the list of this rank's own particles has expired.
/// - `moved`: the greatest distance that a particle of this rank may have moved since ghosts were
///   chosen, a length.
/// - `width`: the width with which ghosts were chosen, a length. It is the same on all ranks.
///
/// Ghosts have expired when a pair across a border may be within the cutoff without being listed.
/// The two particles are on different ranks, and both may have moved. But a rank knows only the
/// moves of its own particles. So each rank assumes that its partner's particles have moved as far
/// as its own particles. The rank whose particles moved furthest is then the first to report that
/// ghosts have expired.
///
/// All ranks must reach the same decision. Otherwise one rank sends positions while another rank
/// sends movers, and both wait forever. So each rank contributes 0 or 1, and a single call gives
/// all ranks the greatest of these numbers ([`CommunicatorCollectives::all_reduce_into`]).
///
/// Book: chapter 13, *When all must agree*.
pub fn must_renew(
    world: &SimpleCommunicator,
    list_has_expired: bool,
    moved: f64,
    width: f64,
) -> bool {
    todo!("task 13.6: all ranks agree that lists have expired")
}
