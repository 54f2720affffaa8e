//! Where the particles of a generated scene stand.

use super::official_size;

/// `n` places in a box of the official density, in rows of nearly √n, 2.2 cutoffs apart.
///
/// Places are numbered row by row, from 0 at the bottom left; the last row may be incomplete.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Lattice {
    /// Number of places.
    pub(crate) n: usize,
    /// Side of the box.
    pub(crate) size: f64,
    /// Places in a row.
    pub(crate) columns: usize,
    /// Number of rows.
    pub(crate) rows: usize,
}

impl Lattice {
    /// The lattice of `n` places, at least 1.
    pub(crate) fn new(n: usize) -> Self {
        let columns = (n as f64).sqrt().ceil() as usize;
        Self { n, size: official_size(n), columns, rows: n.div_ceil(columns) }
    }

    /// Where along x `place` lies.
    pub(crate) fn x(&self, place: usize) -> f64 {
        self.size * (1.0 + (place % self.columns) as f64) / (1 + self.columns) as f64
    }

    /// Where along y all places of `row` lie.
    pub(crate) fn y(&self, row: usize) -> f64 {
        self.size * (1.0 + row as f64) / (1 + self.rows) as f64
    }
}
