//! Task 6.6: particles that move to a neighbour, and particles that move further.

use common_mpi::Wire;
use halo::{Cuts, Leavers};
use solution2::Grid;

/// Sorts `leavers` by their new owners.
///
/// - `leavers` are particles that are no longer in the block of this rank. Each list of the result
///   keeps the order of the leavers.
/// - `neighbours` are the ranks before and after this rank, if they exist
///   ([`neighbours`](crate::neighbours)).
///
/// In an ordinary step a particle moves a twentieth of a cutoff, and all leavers go to a neighbour.
/// But the model allows a particle to cross many blocks in one step.
///
/// Book: chapter 6, *Movers*.
pub fn sort_leavers(
    grid: &Grid,
    cuts: &Cuts,
    neighbours: [Option<usize>; 2],
    leavers: &[Wire],
) -> Leavers {
    let mut sorted = Leavers::default();
    todo!("task 6.6: movers to the neighbours and beyond");
    sorted
}
