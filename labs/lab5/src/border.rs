//! Tasks 5.3 and 5.7: what crosses the border without moving.

use std::ops::Range;

use common::soft::Particle;
use common_mpi::Wire;
use solution2::VecBins;

use crate::Cut;

/// Copies of all particles of `block` that another rank needs to see.
///
/// Those are the particles of every row that has a neighbour on another rank
/// ([`Cut::neighbours`]): the first and the last row of the block, unless it is the wall that lies
/// beyond. *Every* particle of such a row, whether it changed its bin in this step or not: it has
/// moved, and its copy of the step before is where it no longer is.
///
/// Each particle once, even if the block is a single row and two ranks need it: the root knows
/// who needs what. A block may be empty.
///
/// Book: chapter 5, *Ghosts*.
pub fn border_copies(bins: &VecBins, cut: &Cut, block: &Range<usize>) -> Vec<Wire> {
    let columns = bins.grid().columns();
    let mut copies = Vec::new();
    todo!("task 5.3: whose copies the neighbours need");
    copies
}

/// Takes in what came from the root: forgets the ghosts of the step before and puts everybody
/// who `arrived` into its bin.
///
/// Ghosts live in the rows next to the block, `block.start − 1` and `block.end`, as far as the box
/// goes; no other row outside the block holds anything. Whoever arrived is either a particle that
/// is ours from now on or a ghost: the row that it lies in says which, and [`VecBins::put`] finds
/// it. An empty block gets no particles and has no ghosts.
///
/// Book: chapter 5, *Ghosts*.
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
