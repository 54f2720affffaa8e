//! Task 13.6: all ranks agree that lists have expired.

use common::soft::CUTOFF;
use mpi::collective::SystemOperation;
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;

/// Whether all ranks make their lists anew before the next forces: if any of them has to.
///
/// - `list_has_expired`: whether the list of this rank's own particles is.
/// - `moved`: how far a particle of this rank may have gone since ghosts were chosen.
/// - `width`: how wide they were chosen, on all ranks the same.
///
/// Ghosts have expired when a pair across a border may be within the cutoff and is not listed. Both
/// of such a pair may have moved, one here and one on another rank, and a rank knows only how far
/// its own particles went. So let each rank look at its own alone, as if its partner's had gone as
/// far: then the rank whose particles went furthest is the first to say so.
///
/// All ranks must decide alike, else one rank sends positions while another sends movers, and both wait
/// for ever. So each puts in its word, 0 or 1, and all get the greatest
/// ([`CommunicatorCollectives::all_reduce_into`]).
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
