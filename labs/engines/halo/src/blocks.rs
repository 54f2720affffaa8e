//! Blocks of rows: the rows of each rank, and the ranks that need each other's particles.

use std::ops::Range;

use common::soft::Particle;
use common_mpi::Wire;
use solution2::Grid;

/// Rows of bins, divided into a block for each rank: rank k has `starts[k] .. starts[k + 1]`.
///
/// A block may be empty if there are more ranks than rows, or if few rows contain all particles.
#[derive(Clone, Debug, PartialEq)]
pub struct Cuts {
    /// The first row of each block, and finally the number of rows; ascending from 0.
    pub starts: Vec<usize>,
}

impl Cuts {
    /// Gives each rank `rows / ranks` rows, and the last rank the remainder: the CSC581 report's
    /// partition.
    pub(crate) fn remainder_last(rows: usize, ranks: usize) -> Self {
        let each = rows / ranks;
        Self { starts: (0..ranks).map(|rank| rank * each).chain([rows]).collect() }
    }

    /// Returns the rows of `rank`.
    pub fn block(&self, rank: usize) -> Range<usize> {
        self.starts[rank]..self.starts[rank + 1]
    }

    /// Returns the rank that has `row`.
    #[inline]
    pub fn owner(&self, row: usize) -> usize {
        // The row is in the last block that starts at or before it. Earlier blocks are empty or end
        // before the row.
        self.starts.partition_point(|&start| start <= row) - 1
    }

    /// Returns the number of rows of all blocks.
    pub fn rows(&self) -> usize {
        self.starts[self.starts.len() - 1]
    }
}

/// Particles that left their block, sorted by new rank.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Leavers {
    /// Particles for the neighbour before the block, and for the neighbour after it.
    pub near: [Vec<Wire>; 2],
    /// Particles for other ranks, each with the number of its new rank.
    pub far: Vec<(usize, Wire)>,
}

/// A function that calls its argument with each particle of a scene, one after the other.
///
/// The function can be called several times: `replay(&mut |particle| n += 1)` counts the particles.
pub type Replay<'a> = &'a dyn Fn(&mut dyn FnMut(Particle));

/// The decisions about blocks: the division of the rows, and the exchanges between ranks.
pub trait Blocks {
    /// Divides rows into `ranks` blocks. Each row has `counts[row]` particles.
    fn balanced(counts: &[u64], ranks: usize) -> Cuts;

    /// Returns the ranks that have the row before and the row after the block of `rank`, in this
    /// order.
    fn neighbours(cuts: &Cuts, rank: usize) -> [Option<usize>; 2];

    /// Returns the rows of `block` whose particles have all their neighbours on this rank.
    ///
    /// `rows` is the number of rows of the box.
    fn interior_rows(block: &Range<usize>, rows: usize) -> Range<usize>;

    /// Sorts particles by new owner. The particles have left a block that has these `neighbours`.
    fn sort_leavers(
        grid: &Grid,
        cuts: &Cuts,
        neighbours: [Option<usize>; 2],
        leavers: &[Wire],
    ) -> Leavers;

    /// Returns the balanced blocks of a scene, and the particles of `rank`'s block.
    ///
    /// `replay` passes the scene particle by particle, so that no rank has to store all particles.
    fn keep_share(
        grid: &Grid,
        ranks: usize,
        rank: usize,
        replay: Replay<'_>,
    ) -> (Cuts, Vec<Particle>);
}

/// Returns the rows of `block` that need ghosts: the rows before and after its `interior`.
pub fn border_rows(block: &Range<usize>, interior: &Range<usize>) -> [Range<usize>; 2] {
    [block.start..interior.start, interior.end..block.end]
}
