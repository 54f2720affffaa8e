//! The lattice of cells over the square.

use super::work::{HEIGHT, WIDTH, expected_work, mean_box};
use crate::geometry::Square;
use crate::survey::Survey;

/// Columns and rows of cells that cover the positions of the discs.
///
/// A position outside the lattice belongs to the nearest cell. So boxes that overlap in the plane
/// also share a row of the lattice, and their columns begin and end in the same order as in the
/// plane.
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
    /// Whether testing many pairs together is faster.
    ///
    /// Testing pairs together is faster if an entry has several partners, and few of these pairs
    /// ever touch.
    pub(super) in_lanes: bool,
}

/// Returns the number of cells of about this length between two coordinates.
fn cells_along((low, high): (f64, f64), length: f64) -> f64 {
    ((high - low) / length).ceil().clamp(1.0, MOST)
}

fn cells_per_length((low, high): (f64, f64), cells: f64) -> f64 {
    if high > low { cells / (high - low) } else { 0.0 }
}

/// Greatest number of columns or rows.
const MOST: f64 = (1 << 30) as f64;

impl Lattice {
    /// Returns the lattice for a step of `windows` windows.
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

    /// Returns the column of a position.
    #[inline]
    pub(super) fn column(&self, x: f64) -> u32 {
        // The conversion turns negative numbers into 0.
        (((x - self.left) * self.per_width) as u32).min(self.columns - 1)
    }

    /// Returns the row of a position.
    #[inline]
    pub(super) fn row(&self, y: f64) -> u32 {
        (((y - self.bottom) * self.per_height) as u32).min(self.rows - 1)
    }

    /// Returns the number of a cell.
    #[inline]
    pub(super) fn cell(&self, row: u32, column: u32) -> u64 {
        u64::from(row) * u64::from(self.columns) + u64::from(column)
    }

    /// Returns the number of rows.
    pub(super) fn rows(&self) -> u32 {
        self.rows
    }
}
