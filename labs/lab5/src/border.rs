//! Tasks 5.3 and 5.7: ghosts, copies of particles on the other side of a border between ranks.

use std::ops::Range;

use common::soft::Particle;
use common_mpi::Wire;
use solution2::VecBins;

use crate::Cut;

/// Copies of the particles of `block` that other ranks need as ghosts, in any order.
///
/// They lie in the border rows: the rows of the block that have a neighbouring row on another rank
/// ([`Cut::neighbours`] names these ranks). *Every* particle of a border row is copied, whether it
/// changed its bin in this step or not: it has moved, and the copy made in the step before lies
/// where the particle no longer is.
///
/// Each particle is copied once, even if the block is a single row with a neighbour on either
/// side: the root sends the copy to both. A block may be empty.
///
/// [`VecBins::bins`] has the bins row by row, `columns` in each, and [`Wire::from`] a particle is its
/// copy.
///
/// Book: chapter 5, *Ghosts*.
pub fn border_copies(bins: &VecBins, cut: &Cut, block: &Range<usize>) -> Vec<Wire> {
    let columns = bins.grid().columns();
    let mut copies = Vec::new();
    todo!("task 5.3: copies of the border rows");
    copies
}

/// Takes in what came from the root: clears the ghosts of the step before and puts every particle
/// of `arrived` into its bin.
///
/// Ghosts lie in the rows next to the block, `block.start − 1` and `block.end`, where the box has
/// such a row; no other row outside the block holds anything. A particle of `arrived` is either
/// owned by this rank from now on or a ghost. The row that it lies in tells which, and
/// [`VecBins::put`] finds that row, so both are treated alike. An empty block gets no particles and
/// has no ghosts.
///
/// [`VecBins::bins_mut`] has the bins row by row, `columns` in each, and [`Particle::from`] a wire is
/// the particle itself.
///
/// Book: chapter 5, *The stale ghosts*.
pub fn replace_ghosts(bins: &mut VecBins, block: &Range<usize>, arrived: &[Wire]) {
    let columns = bins.grid().columns();
    todo!("task 5.7: old ghosts go, new ones come")
}

/// The particles of `block`, ghosts left out, in the order of their bins.
pub(crate) fn own<'a>(
    bins: &'a VecBins,
    block: &Range<usize>,
) -> impl Iterator<Item = &'a Particle> {
    let columns = bins.grid().columns();
    bins.bins()[block.start * columns..block.end * columns].iter().flatten()
}
