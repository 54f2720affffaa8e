//! Positions in single precision, relative to their cell.

/// The position of a particle: a cell, and the distance from its lower left corner.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Position {
    /// The cell's column.
    pub(super) column: u32,
    /// The cell's row.
    pub(super) row: u32,
    /// Distance from the cell's left edge.
    pub(super) x: f32,
    /// Distance from the cell's lower edge.
    pub(super) y: f32,
}

// ANCHOR: vector
/// Returns the vector from one position to another in the same or an adjacent cell.
///
/// `side` is the side of a cell. Differences of columns are exact, and they are taken before the
/// multiplication. So the error does not depend on the position of the cells in the box.
#[inline]
pub(super) fn vector(from: &Position, to: &Position, side: f32) -> (f32, f32) {
    let columns = to.column as i32 - from.column as i32;
    let rows = to.row as i32 - from.row as i32;
    (columns as f32 * side + (to.x - from.x), rows as f32 * side + (to.y - from.y))
}
// ANCHOR_END: vector

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_distance_does_not_depend_on_where_the_cells_are() {
        for column in [1, 70_000, 100_000_000_u32] {
            let from = Position { column, row: 5, x: 0.009, y: 0.002 };
            let to = Position { column: column + 1, row: 4, x: 0.001, y: 0.008 };
            let (dx, dy) = vector(&from, &to, 0.01);
            assert!((dx - 0.002).abs() < 2e-9, "dx = {dx} from column {column} to the next");
            assert!((dy + 0.004).abs() < 2e-9, "dy = {dy} from row 5 to row 4");
            assert_eq!(vector(&to, &from, 0.01), (-dx, -dy), "the way back from column {column}");
        }
    }
}
