//! Entries: a disc in a row of cells.

/// A disc in a row of cells that its box reaches into.
///
/// A disc has an entry in every row that its box touches, but only one entry in each row: in the
/// column where the box begins. Only cells in which a box begins are stored, so memory grows with
/// the number of discs and not with the square.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Entry {
    /// The cell in which the box begins in this row: row × columns + column.
    pub cell: u64,
    /// Number of further columns that the box reaches into.
    pub further: u32,
    /// The disc's number. The highest bit is set if this is not the first row of the disc.
    disc: u32,
}

const NOT_FIRST: u32 = 1 << 31;

impl Entry {
    /// Makes an entry of disc number `disc`; `first` if no row below contains the disc.
    #[inline]
    pub fn new(cell: u64, further: u32, disc: u32, first: bool) -> Self {
        Self { cell, further, disc: disc | if first { 0 } else { NOT_FIRST } }
    }

    /// Returns the disc's number.
    #[inline]
    pub fn disc(&self) -> u32 {
        self.disc & !NOT_FIRST
    }

    /// Whether this is the lowest row of the disc.
    #[inline]
    pub fn is_first(&self) -> bool {
        self.disc & NOT_FIRST == 0
    }
}
