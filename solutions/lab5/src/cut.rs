//! Task 5.1: the rows of each rank.

use std::ops::Range;

/// The division of `rows` rows of bins into blocks of adjacent rows, one for each of `ranks` ranks.
///
/// The blocks are as equal as possible. Rank k has the rows from k · `rows` / `ranks` up to, not
/// including, (k + 1) · `rows` / `ranks`, both rounded down. Every block begins where the previous
/// block ends, so each row belongs to exactly one rank, for any numbers of rows and ranks. If there
/// are more ranks than rows, some blocks are empty.
///
/// (The obvious division, `rows / ranks` rows for each rank, is wrong in two ways. If the division
/// leaves a remainder, the last rows belong to no rank. If there are more ranks than rows, no rank
/// has any rows.)
// ANCHOR: cut
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cut {
    /// The number of rows, at least 1.
    pub rows: usize,
    /// The number of ranks, at least 1.
    pub ranks: usize,
}
// ANCHOR_END: cut

impl Cut {
    /// Returns the rows of `rank`, which is less than [`ranks`](Self::ranks).
    ///
    /// Book: chapter 5, *Blocks of rows*.
    pub fn block(&self, rank: usize) -> Range<usize> {
        // task 5.1: the rows of a rank
        let start = |rank: usize| rank * self.rows / self.ranks;
        start(rank)..start(rank + 1)
        // end 5.1
    }

    /// Returns the rank that has `row`: the only rank whose [`block`](Self::block) contains this
    /// row.
    ///
    /// `row` is less than [`rows`](Self::rows). The root calls this for every particle that it
    /// sends on, so do not try one rank after another. Solve the inequality k · `rows` / `ranks` ≤
    /// `row`, with its left side rounded down, for the greatest k.
    ///
    /// Book: chapter 5, *Blocks of rows*.
    #[inline]
    pub fn owner(&self, row: usize) -> usize {
        // task 5.1b: the rank of a row
        ((row + 1) * self.ranks - 1) / self.rows
        // end 5.1b
    }

    /// Yields the other ranks that need ghosts of the particles in `row`.
    ///
    /// They are the owners of the previous row and of the next row, unless these rows have the same
    /// owner as `row`. A row inside a block yields no rank, a border row yields one rank, and the
    /// row of a single-row block yields two ranks.
    pub fn neighbours(&self, row: usize) -> impl Iterator<Item = usize> {
        let owner = self.owner(row);
        let before = row.checked_sub(1);
        let after = (row + 1 < self.rows).then_some(row + 1);
        let cut = *self;
        let ranks = [before, after].into_iter().flatten().map(move |row| cut.owner(row));
        ranks.filter(move |&rank| rank != owner)
    }
}
