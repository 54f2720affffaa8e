//! The sites of the particles of a generated scene.

use super::DENSITY;

/// Returns the side of the official box for `n` particles.
pub fn official_size(n: usize) -> f64 {
    (DENSITY * n as f64).sqrt()
}

/// `n` sites in a box of the official density, in rows of nearly √n, 2.2 cutoffs apart.
///
/// Sites are numbered row by row, from 0 at the bottom left; the last row may be incomplete.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Lattice {
    /// Number of sites.
    pub(crate) n: usize,
    /// Side of the box.
    pub(crate) size: f64,
    /// Sites in a row.
    pub(crate) columns: usize,
    /// Number of rows.
    pub(crate) rows: usize,
}

impl Lattice {
    /// Makes the lattice of `n` sites, at least 1.
    pub(crate) fn new(n: usize) -> Self {
        let columns = (n as f64).sqrt().ceil() as usize;
        Self { n, size: official_size(n), columns, rows: n.div_ceil(columns) }
    }

    /// Returns x of `site`.
    pub(crate) fn x(&self, site: usize) -> f64 {
        self.size * (1.0 + (site % self.columns) as f64) / (1 + self.columns) as f64
    }

    /// Returns y of all sites of `row`.
    pub(crate) fn y(&self, row: usize) -> f64 {
        self.size * (1.0 + row as f64) / (1 + self.rows) as f64
    }
}
