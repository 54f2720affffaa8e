//! A disc in a row of cells.

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
    #[inline]
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
