//! Tasks 2.1 and 2.2: the geometry of the bins.

use std::ops::Range;

use common::soft::{CUTOFF, Particle, Scene};

/// The greatest number of bins, as a multiple of the number of particles.
///
/// At the official density and a bin size of one cutoff, there are 5 bins for each particle.
/// Without this limit, a scene with few particles in a wide box would have millions of bins.
const BINS_PER_PARTICLE: usize = 8;

/// The margin of the side of a bin, as a fraction of the least side.
///
/// Bins are wider by this margin. Otherwise rounding might put two particles within the cutoff two
/// bins apart.
const MARGIN: f64 = 1e-9;

/// A square box of side `size`, cut into equal square bins, with as many rows as columns.
///
/// Row 0 is at y = 0, and column 0 is at x = 0. Bins are numbered row by row: bin = row · columns +
/// column. All sides are lengths in the units of the scene.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Grid {
    size: f64,
    along: usize,
    bins_per_length: f64,
}

impl Grid {
    /// Makes the grid for `n` particles in a box of side `size`, with bins at least `least` wide.
    pub fn new(size: f64, least: f64, n: usize) -> Self {
        Self::with_bins_along(size, bins_along(size, least, n))
    }

    /// Makes the grid with exactly `along` bins along each wall. `along` must be at least 1.
    pub fn with_bins_along(size: f64, along: usize) -> Self {
        Self { size, along, bins_per_length: along as f64 / size }
    }

    /// Makes the grid for `scene`, with bins at least `bin_size` cutoffs wide.
    pub fn of_scene(scene: &Scene, bin_size: f64) -> Self {
        Self::new(scene.size(), bin_size * CUTOFF, scene.len())
    }

    /// The side of the box, a length.
    pub fn size(&self) -> f64 {
        self.size
    }

    /// The side of a bin, a length.
    pub fn bin_side(&self) -> f64 {
        self.size / self.along as f64
    }

    /// The number of rows of bins.
    #[inline]
    pub fn rows(&self) -> usize {
        self.along
    }

    /// The number of bins in a row.
    #[inline]
    pub fn columns(&self) -> usize {
        self.along
    }

    /// The number of bins.
    pub fn bins(&self) -> usize {
        self.along * self.along
    }

    /// The row of bins that contains `y`.
    #[inline]
    pub fn row(&self, y: f64) -> usize {
        self.index(y)
    }

    /// The column of bins that contains `x`.
    #[inline]
    pub fn column(&self, x: f64) -> usize {
        self.index(x)
    }

    /// The number of the bin that contains `particle`.
    #[inline]
    pub fn bin(&self, particle: &Particle) -> usize {
        self.row(particle.y) * self.columns() + self.column(particle.x)
    }

    /// Returns the row or column that contains the coordinate `x`, 0 ≤ x ≤ `size`.
    ///
    /// In two special cases, the particle is in the last bin. It may be exactly on the wall, at x =
    /// `size`. And for a particle just below the wall, the product of `x` and `bins_per_length` may
    /// be rounded up to the number of bins.
    ///
    /// Book: chapter 2, *The bins*.
    #[inline]
    fn index(&self, x: f64) -> usize {
        todo!("task 2.1b: which bin a coordinate lies in")
    }

    /// Returns `index` and the indices next to it. An index at a wall has only one neighbour.
    ///
    /// These are the rows (or columns) in which a particle of row (or column) `index` can have
    /// neighbours.
    ///
    /// Book: chapter 2, *The bins*.
    #[inline]
    pub fn near(&self, index: usize) -> Range<usize> {
        todo!("task 2.2: the bins next to a bin")
    }
}

/// Returns the number of bins that fit along a wall of length `size`, at least 1.
///
/// - Bins fill the box evenly, so the side of a bin is `size` divided by the number of bins. Divide
///   `size` by `least` · (1 + [`MARGIN`]), and round down. With the margin, a side is never less than
///   `least`, even if the division rounds up.
/// - Memory must grow with the number of particles, not with the box. So rows times columns must be at
///   most [`BINS_PER_PARTICLE`] · `n`. The limit along a wall is the square root of
///   [`BINS_PER_PARTICLE`] · `n`. Wider bins always give right results, but take longer.
/// - The box may be smaller than one bin. It may also be so large that `size / least` does not fit
///   in a `usize`. (`as usize` saturates.)
///
/// Book: chapter 2, *The bins*.
fn bins_along(size: f64, least: f64, n: usize) -> usize {
    todo!("task 2.1: how many bins fit")
}
