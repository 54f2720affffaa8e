//! The bins.

use common::soft::CUTOFF;

/// How the box is divided: `columns` × `columns` bins of side `side`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grid {
    /// Side of the box.
    pub size: f64,
    /// Bins along x, and as many along y.
    pub columns: u32,
    /// Side of a bin, `size / columns`.
    pub side: f64,
}

/// Bins are so much wider than the cutoff that no rounding, not even that of single precision,
/// lets two particles at the cutoff be two bins apart.
const SLACK: f64 = 1.0 + 1.0 / (1 << 20) as f64;

impl Grid {
    /// Bins of at least `bin` cutoffs (1 or more) in a box of side `size`, but not many more than
    /// the `n` particles in it: an empty plain needs no bins.
    pub fn new(size: f64, n: usize, bin: f64) -> Self {
        let most = (8.0 * n as f64).sqrt().clamp(64.0, 46_340.0);
        let columns = (size / (CUTOFF * bin * SLACK)).floor().clamp(1.0, most);
        Self { size, columns: columns as u32, side: size / columns }
    }

    /// Number of bins.
    pub fn bins(&self) -> u32 {
        self.columns * self.columns
    }

    /// The column of coordinate `x`, or the row of `y`. The far wall belongs to the last.
    pub fn column(&self, x: f64) -> u32 {
        ((x / self.side) as u32).min(self.columns - 1)
    }
}
