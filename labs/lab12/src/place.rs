//! Positions in single precision, relative to their cell.

/// Where a particle is: a cell, and the position from its lower left corner.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Place {
    /// The cell's column.
    pub column: u32,
    /// The cell's row.
    pub row: u32,
    /// From the cell's left edge, in units of length.
    pub x: f32,
    /// From the cell's lower edge, in units of length.
    pub y: f32,
}

/// The vector from one position to another in the same or an adjacent cell, x and y in single
/// precision; `side` is a cell's. Its error must not depend on where the cells are: take
/// differences of columns before anything is multiplied.
///
/// Book: chapter 12, *Seven digits*.
#[inline]
pub fn vector(from: &Place, to: &Place, side: f32) -> (f32, f32) {
    todo!("task 12.6: a distance across cells")
}
