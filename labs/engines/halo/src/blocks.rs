//! Blocks of rows: which rank has which, and who needs what of whom.

use std::ops::Range;

use common::soft::Particle;
use common_mpi::Wire;
use solution2::Grid;

/// Rows of bins, cut into a block for each rank: rank k has `starts[k] .. starts[k + 1]`. Blocks
/// may be empty, where ranks outnumber rows or few rows hold all particles.
#[derive(Clone, Debug, PartialEq)]
pub struct Cuts {
    /// Ascending, from 0 to the number of rows; one more than there are ranks.
    pub starts: Vec<usize>,
}

impl Cuts {
    /// `rows / ranks` rows for each rank, and what is left over for the last one: the CSC581 report's cut.
    pub(crate) fn remainder_last(rows: usize, ranks: usize) -> Self {
        let each = rows / ranks;
        Self { starts: (0..ranks).map(|rank| rank * each).chain([rows]).collect() }
    }

    /// The rows of `rank`.
    pub fn block(&self, rank: usize) -> Range<usize> {
        self.starts[rank]..self.starts[rank + 1]
    }

    /// The rank that has `row`.
    #[inline]
    pub fn owner(&self, row: usize) -> usize {
        // The last block that starts at or before it: blocks before that one are empty or over.
        self.starts.partition_point(|&start| start <= row) - 1
    }

    /// The number of rows of all blocks.
    pub fn rows(&self) -> usize {
        self.starts[self.starts.len() - 1]
    }
}

/// Particles that left their block, sorted by the rank that they must go to.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Leavers {
    /// To the neighbour before and to the neighbour after.
    pub near: [Vec<Wire>; 2],
    /// To any other rank, with its number.
    pub far: Vec<(usize, Wire)>,
}

/// Calls a function with each particle of a scene, one after the other, as often as it is asked to:
/// `replay(&mut |particle| n += 1)` counts them.
pub type Replay<'a> = &'a dyn Fn(&mut dyn FnMut(Particle));

/// How rows are cut into blocks, and what ranks need of each other.
pub trait Blocks {
    /// Cuts rows that hold `counts[row]` particles each into `ranks` blocks.
    fn balanced(counts: &[u64], ranks: usize) -> Cuts;

    /// The ranks that have the row before and the row after the block of `rank`, in this order.
    fn neighbours(cuts: &Cuts, rank: usize) -> [Option<usize>; 2];

    /// The rows of `block` whose particles have all their neighbours on this rank, of a box with `rows` rows.
    fn interior_rows(block: &Range<usize>, rows: usize) -> Range<usize>;

    /// Sorts particles that left a block with these `neighbours` by their new owners.
    fn sort_leavers(
        grid: &Grid,
        cuts: &Cuts,
        neighbours: [Option<usize>; 2],
        leavers: &[Wire],
    ) -> Leavers;

    /// The balanced cuts of a scene and the particles of `rank`'s block, from a scene that comes one particle after the
    /// other.
    fn keep_share(
        grid: &Grid,
        ranks: usize,
        rank: usize,
        replay: Replay<'_>,
    ) -> (Cuts, Vec<Particle>);
}

/// The other rows of `block`, before and after its `interior`: those that wait for ghosts.
pub fn border_rows(block: &Range<usize>, interior: &Range<usize>) -> [Range<usize>; 2] {
    [block.start..interior.start, interior.end..block.end]
}
