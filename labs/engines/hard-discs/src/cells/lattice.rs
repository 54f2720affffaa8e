//! How the square is cut into cells.

use super::work::{HEIGHT, WIDTH, expected_work, mean_box};
use crate::geometry::Square;
use crate::survey::Survey;

/// Columns and rows of cells that cover the positions of the discs.
///
/// Positions beyond the lattice count to its outermost cells, so that whatever overlaps in the plane
/// shares a row, and begins and ends in the right order of columns, on the lattice too.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Lattice {
    left: f64,
    bottom: f64,
    per_width: f64,
    per_height: f64,
    columns: u32,
    rows: u32,
    /// The greatest velocity component of the scene.
    pub(super) fastest: f64,
    /// Whether it pays to look at many pairs together: an entry has several partners, and few pairs
    /// must be asked when they touch.
    pub(super) in_lanes: bool,
}

/// The number of cells of about this length between two coordinates.
fn cells_along((low, high): (f64, f64), length: f64) -> f64 {
    ((high - low) / length).ceil().clamp(1.0, MOST)
}

fn cells_per_length((low, high): (f64, f64), cells: f64) -> f64 {
    if high > low { cells / (high - low) } else { 0.0 }
}

/// More columns or rows than this are not told apart.
const MOST: f64 = (1 << 30) as f64;

impl Lattice {
    /// The lattice for a step of `windows` windows.
    pub(super) fn new(survey: &Survey, square: Square, windows: usize) -> Self {
        let (width, height) = mean_box(survey, square, windows);
        let work = expected_work(survey, square, windows);
        let columns = cells_along(survey.x, WIDTH * width);
        let rows = cells_along(survey.y, HEIGHT * height);
        Self {
            left: survey.x.0,
            bottom: survey.y.0,
            per_width: cells_per_length(survey.x, columns),
            per_height: cells_per_length(survey.y, rows),
            columns: columns as u32,
            rows: rows as u32,
            fastest: survey.fastest,
            in_lanes: work.pairs > work.entries && work.asked < 0.5 * work.pairs,
        }
    }

    /// The column of a position.
    #[inline]
    pub(super) fn column(&self, x: f64) -> u32 {
        // The conversion takes what is negative to 0.
        (((x - self.left) * self.per_width) as u32).min(self.columns - 1)
    }

    /// The row of a position.
    #[inline]
    pub(super) fn row(&self, y: f64) -> u32 {
        (((y - self.bottom) * self.per_height) as u32).min(self.rows - 1)
    }

    /// The number of a cell.
    #[inline]
    pub(super) fn cell(&self, row: u32, column: u32) -> u64 {
        u64::from(row) * u64::from(self.columns) + u64::from(column)
    }

    /// Number of rows.
    pub(super) fn rows(&self) -> u32 {
        self.rows
    }
}
