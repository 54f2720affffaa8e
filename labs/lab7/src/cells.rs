//! Task 7.13: sorted occupied cells.

use std::ops::Range;

/// A disc in a row of cells that its box reaches into.
///
/// A disc is entered in every row that its box touches, but only once in each: in the column
/// where the box begins. Only cells where a box begins exist at all, so that memory grows with the
/// number of discs and not with the square.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Entry {
    /// The cell where the box begins in this row: row × columns + column.
    pub cell: u64,
    /// In how many further columns the box goes on.
    pub further: u32,
    /// The disc's number; the highest bit says that this is not the first row that it is in.
    disc: u32,
}

const NOT_FIRST: u32 = 1 << 31;

impl Entry {
    /// An entry of disc number `disc`; `first` if it is in no row below.
    pub fn new(cell: u64, further: u32, disc: u32, first: bool) -> Self {
        Self { cell, further, disc: disc | if first { 0 } else { NOT_FIRST } }
    }

    /// The disc's number.
    #[inline]
    pub fn disc(&self) -> u32 {
        self.disc & !NOT_FIRST
    }

    /// Whether this is the lowest row that the disc is in.
    #[inline]
    pub fn is_first(&self) -> bool {
        self.disc & NOT_FIRST == 0
    }
}

/// The entries behind entry `k` whose boxes share a column with its box: their indices.
///
/// `entries` are sorted by cell, so a row is a stretch of them, and within a row boxes stand in
/// the order of the columns where they begin. The boxes that begin in the columns of entry `k`, from
/// its own cell up to `further` columns on, follow it directly. The last column of a
/// row and the first of the next have neighbouring numbers, but no box goes on beyond the last column.
///
/// Over all k that is every two entries of the same row whose boxes share a column, once. A pair of discs may
/// share several rows and then comes up in each; the caller sorts that out.
///
/// Book: chapter 7, *Sorted occupied cells*.
#[inline(always)]
pub fn partners(entries: &[Entry], k: usize) -> Range<usize> {
    todo!("task 7.13: boxes that share a column")
}
