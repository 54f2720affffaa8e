//! Who looks at which pairs: blocks of discs, dealt to workers.

use std::ops::Range;

/// A rectangle of the matrix of all pairs, or the triangle where it meets the diagonal: the discs
/// of block `row` with those of block `column`, `row` ≤ `column`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Job {
    /// The block of the first discs.
    pub row: usize,
    /// The block of the second discs.
    pub column: usize,
    /// Which of the discs of block `row` are looked at.
    pub part: Part,
}

/// A block, or half of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Part {
    /// All of it.
    Whole,
    /// The first half, rounded down.
    First,
    /// The rest.
    Second,
}

impl Part {
    /// This part of a block of discs.
    pub fn of(self, block: Range<usize>) -> Range<usize> {
        let middle = block.start + block.len() / 2;
        match self {
            Self::Whole => block,
            Self::First => block.start..middle,
            Self::Second => middle..block.end,
        }
    }
}

/// How all pairs are dealt to workers.
///
/// With W workers the discs are cut into W blocks. Think of the blocks on a ring, as hours on a
/// clock: two of them are some distance 0 … W / 2 apart, whichever way round is shorter.
/// Worker k has the blocks k + `offsets`, modulo W. All workers have the same pattern, each
/// turned one further.
// ANCHOR: deal
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Deal {
    /// Number of workers W, and of blocks.
    pub workers: usize,
    /// Which blocks worker 0 has. Two of them are any given distance apart.
    pub offsets: Vec<usize>,
}
// ANCHOR_END: deal

impl Deal {
    /// The blocks that `worker` needs: a row of the report's `send_mat`. The first is the worker's
    /// own, block `worker`.
    pub fn blocks(&self, worker: usize) -> Vec<usize> {
        self.offsets.iter().map(|offset| (worker + offset) % self.workers).collect()
    }
}
