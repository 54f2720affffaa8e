//! Task 5.1: which rank has which rows.

use std::ops::Range;

/// `rows` rows of bins, cut into a block of adjacent rows for each of `ranks` ranks, as even as can
/// be.
///
/// Rank k has the rows from k · `rows` / `ranks` up to, not including, (k + 1) · `rows` / `ranks`,
/// both rounded down. Where one block ends the next begins, so no row is lost and none is doubled,
/// whatever the numbers are. With more ranks than rows some blocks are empty.
///
/// (`rows / ranks` rows for each rank is the obvious cut, and wrong twice: the last rows belong to
/// no rank when the division leaves a remainder, and no rank has any row when ranks outnumber
/// rows.)
// ANCHOR: cut
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cut {
    /// Number of rows, at least 1.
    pub rows: usize,
    /// Number of ranks, at least 1.
    pub ranks: usize,
}
// ANCHOR_END: cut

impl Cut {
    /// The rows of `rank`, which is less than [`ranks`](Self::ranks).
    ///
    /// Book: chapter 5, *Blocks of rows*.
    pub fn block(&self, rank: usize) -> Range<usize> {
        // task 5.1: the rows of a rank
        let start = |rank: usize| rank * self.rows / self.ranks;
        start(rank)..start(rank + 1)
        // end 5.1
    }

    /// The rank that has `row`: the only one whose [`block`](Self::block) contains it. `row` is less
    /// than [`rows`](Self::rows).
    ///
    /// The root asks this for every particle that passes through it. Do not search: the inequality
    /// k · `rows` / `ranks` ≤ `row`, its left side rounded down, can be solved for the greatest k.
    ///
    /// Book: chapter 5, *Blocks of rows*.
    #[inline]
    pub fn owner(&self, row: usize) -> usize {
        // task 5.1b: the rank of a row
        ((row + 1) * self.ranks - 1) / self.rows
        // end 5.1b
    }

    /// The other ranks that need ghosts of the particles in `row`: the owners of the row before it
    /// and of the row after it, if these are not its own owner. None for a row inside a block, one
    /// for a border row, two for a block of a single row.
    pub fn neighbours(&self, row: usize) -> impl Iterator<Item = usize> {
        let owner = self.owner(row);
        let before = row.checked_sub(1);
        let after = (row + 1 < self.rows).then_some(row + 1);
        let cut = *self;
        let ranks = [before, after].into_iter().flatten().map(move |row| cut.owner(row));
        ranks.filter(move |&rank| rank != owner)
    }
}
