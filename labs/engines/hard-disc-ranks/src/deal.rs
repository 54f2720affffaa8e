//! The distribution of pairs to workers: blocks of discs, and jobs that are pairs of blocks.

use std::ops::Range;

/// The pairs of discs of block `row` with discs of block `column`, `row` ≤ `column`.
///
/// In the matrix of all pairs this is a rectangle, or a triangle on the diagonal.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Job {
    /// The block of the first discs.
    pub row: usize,
    /// The block of the second discs.
    pub column: usize,
    /// The part of block `row` that belongs to the job.
    pub part: Part,
}

/// A block, or half of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Part {
    /// The whole block.
    Whole,
    /// The first half, rounded down.
    First,
    /// The rest of the block.
    Second,
}

impl Part {
    /// Returns this part of a block of discs.
    pub fn of(self, block: Range<usize>) -> Range<usize> {
        let middle = block.start + block.len() / 2;
        match self {
            Self::Whole => block,
            Self::First => block.start..middle,
            Self::Second => middle..block.end,
        }
    }
}

/// The distribution of all pairs to workers.
///
/// With W workers there are W blocks of discs. The blocks are on a ring, like hours on a clock: the
/// distance between two blocks, on the shorter way round, is from 0 to W / 2. Worker k has the
/// blocks k + `offsets`, modulo W. So all workers have the same pattern of blocks, and each
/// worker's pattern is turned one block further than the previous worker's.
// ANCHOR: deal
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Deal {
    /// Number of workers W, and of blocks.
    pub workers: usize,
    /// The blocks of worker 0. For every distance, two of these blocks are this distance apart.
    pub offsets: Vec<usize>,
}
// ANCHOR_END: deal

impl Deal {
    /// Returns the blocks that `worker` needs: a row of the report's `send_mat`.
    ///
    /// The first block is the worker's own block, number `worker`.
    pub fn blocks(&self, worker: usize) -> Vec<usize> {
        self.offsets.iter().map(|offset| (worker + offset) % self.workers).collect()
    }
}
