//! Tasks 5.3 and 5.7: ghosts, copies of particles from the other side of a border between ranks.

use std::ops::Range;

use common::soft::Particle;
use common_mpi::Wire;
use solution2::VecBins;

use crate::Cut;

/// Returns copies of the particles of `block` that other ranks need as ghosts, in any order.
///
/// - Copy *every* particle of the border rows. These are the rows of the block with a neighbouring
///   row on another rank ([`Cut::neighbours`] yields these ranks).
/// - Copy a particle even if it did not change its bin in this step. Every particle has moved, so
///   the position in the previous copy is out of date.
/// - Copy each particle once, even if the block is a single row with neighbours on both sides. The
///   root sends the copy to both ranks.
/// - A block may be empty.
///
/// [`VecBins::bins`] returns the bins row by row, with `columns` bins in each row. [`Wire::from`]
/// makes the copy of a particle.
///
/// Book: chapter 5, *Ghosts*.
pub fn border_copies(bins: &VecBins, cut: &Cut, block: &Range<usize>) -> Vec<Wire> {
    let columns = bins.grid().columns();
    let mut copies = Vec::new();
    todo!("task 5.3: copies of the border rows");
    copies
}

/// Replaces the ghosts of the previous step with the particles that arrived from the root.
///
/// - First remove all particles from the ghost rows. These are the rows next to the block,
///   `block.start − 1` and `block.end`, if the box has these rows. All other rows outside the block
///   are empty.
/// - Then put every particle of `arrived` into its bin. It is either a ghost, or a particle that
///   this rank owns from now on. Only its row decides which of the two it is. [`VecBins::put`]
///   finds the row, so treat both in the same way.
/// - A rank with an empty block has no ghosts, and receives no particles.
///
/// [`VecBins::bins_mut`] returns the bins row by row, with `columns` bins in each row.
/// [`Particle::from`] converts a wire to a particle.
///
/// Book: chapter 5, *The stale ghosts*.
pub fn replace_ghosts(bins: &mut VecBins, block: &Range<usize>, arrived: &[Wire]) {
    let columns = bins.grid().columns();
    todo!("task 5.7: old ghosts go, new ones come")
}

/// Returns the particles of `block` without ghosts, in the order of their bins.
pub(crate) fn own<'a>(
    bins: &'a VecBins,
    block: &Range<usize>,
) -> impl Iterator<Item = &'a Particle> {
    let columns = bins.grid().columns();
    bins.bins()[block.start * columns..block.end * columns].iter().flatten()
}
