//! Tasks 6.1 and 6.2: blocks of rows, and who is next to whom.

use std::ops::Range;

/// Rows of bins, cut into a block for each rank: rank k has `starts[k] .. starts[k + 1]`. Blocks
/// may be empty, where there are more ranks than rows or few rows hold everybody.
#[derive(Clone, Debug, PartialEq)]
pub struct Cuts {
    /// Ascending, from 0 to the number of rows; one more than there are ranks.
    pub starts: Vec<usize>,
}

impl Cuts {
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

    /// The ranks that have the row before and the row after the block of `rank`, in this order.
    ///
    /// At a wall there is none. A rank whose block is empty has no neighbours, and is nobody's
    /// neighbour: it is skipped, and the row next door belongs to a rank further on. With a block
    /// of rows a..b those rows are a − 1 and b, and [`owner`](Self::owner) knows whose they are.
    ///
    /// Book: chapter 6, *Neighbours*.
    pub fn neighbours(&self, rank: usize) -> [Option<usize>; 2] {
        let block = self.block(rank);
        let rows = self.starts[self.starts.len() - 1];
        todo!("task 6.2: who the neighbours are")
    }
}

/// Cuts rows that hold `counts[row]` particles each into `ranks` blocks of nearly equal numbers of
/// particles.
///
/// Of all N particles, k · N / `ranks` should stand before the block of rank k. A cut can only be
/// made between rows: block k starts at the first row before which at least that many stand (an
/// integer division, rounded down). So no block has more than N / `ranks` + 1 and the particles of
/// one row. Block 0 starts at row 0, the last one ends at the last row, and if there are no
/// particles at all every row still belongs to somebody.
///
/// Return `ranks` + 1 starts, ascending.
///
/// Book: chapter 6, *Balance*.
pub fn balanced(counts: &[u64], ranks: usize) -> Cuts {
    todo!("task 6.1: blocks with as many particles as each other")
}
