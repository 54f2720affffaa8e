//! Tasks 2.1 and 2.2: the geometry of the bins.

use std::ops::Range;

use common::soft::{CUTOFF, Particle, Scene};

/// The most bins for each particle. The official density has 5 at a bin size of one
/// cutoff; a scene with few particles in a wide box would have millions.
const BINS_PER_PARTICLE: usize = 8;

/// Bins are wider than asked for by this fraction, so that rounding can never put two particles
/// within the cutoff two bins apart.
const MARGIN: f64 = 1e-9;

/// A square box of side `size`, cut into equal square bins, as many rows as columns.
///
/// Row 0 lies at y = 0 and column 0 at x = 0. Bins are numbered row by row: bin = row · columns +
/// column. All sides are lengths in the units of the scene.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Grid {
    size: f64,
    along: usize,
    bins_per_length: f64,
}

impl Grid {
    /// The grid for `n` particles in a box of side `size`, with bins of side `least` or more.
    pub fn new(size: f64, least: f64, n: usize) -> Self {
        Self::with_bins_along(size, bins_along(size, least, n))
    }

    /// The grid with exactly `along` bins along each wall, at least 1.
    pub fn with_bins_along(size: f64, along: usize) -> Self {
        Self { size, along, bins_per_length: along as f64 / size }
    }

    /// The grid for `scene` with bins of `bin_size` cutoffs or more.
    pub fn of_scene(scene: &Scene, bin_size: f64) -> Self {
        Self::new(scene.size(), bin_size * CUTOFF, scene.len())
    }

    /// Side of the box.
    pub fn size(&self) -> f64 {
        self.size
    }

    /// Side of a bin.
    pub fn bin_side(&self) -> f64 {
        self.size / self.along as f64
    }

    /// Number of rows of bins.
    #[inline]
    pub fn rows(&self) -> usize {
        self.along
    }

    /// Number of bins in a row.
    #[inline]
    pub fn columns(&self) -> usize {
        self.along
    }

    /// Number of bins.
    pub fn bins(&self) -> usize {
        self.along * self.along
    }

    /// The row of bins that `y` lies in.
    #[inline]
    pub fn row(&self, y: f64) -> usize {
        self.index(y)
    }

    /// The column of bins that `x` lies in.
    #[inline]
    pub fn column(&self, x: f64) -> usize {
        self.index(x)
    }

    /// The bin that a particle lies in.
    #[inline]
    pub fn bin(&self, particle: &Particle) -> usize {
        self.row(particle.y) * self.columns() + self.column(particle.x)
    }

    /// Which of the bins along a wall the coordinate `x`, 0 ≤ x ≤ `size`, lies in.
    ///
    /// The box is closed: a particle may lie exactly on the wall at x = `size`, and a little below
    /// it the product of `x` and `bins_per_length` may be rounded up to the number of bins. Both
    /// belong to the last bin.
    ///
    /// Book: chapter 2, *The bins*.
    #[inline]
    fn index(&self, x: f64) -> usize {
        todo!("task 2.1b: which bin a coordinate lies in")
    }

    /// The indices next to `index`, itself among them: the rows (or columns) in which a particle
    /// of that row (or column) can have neighbours. At a wall there is nothing beyond.
    ///
    /// Book: chapter 2, *The bins*.
    #[inline]
    pub fn near(&self, index: usize) -> Range<usize> {
        todo!("task 2.2: the bins next to a bin")
    }
}

/// How many bins fit along a wall of length `size`: at least 1.
///
/// - Bins fill the box evenly, so their side is `size` over their number. Divide `size` by
///   `least` · (1 + [`MARGIN`]) and round down. The margin is there because the division itself may
///   round up: with it a side is never less than `least`.
/// - Memory must grow with the particles, not with the box: no more than [`BINS_PER_PARTICLE`] · `n`
///   bins in all, rows times columns, so the root of that along a wall. Wider bins are always right,
///   only slower.
/// - The box may be smaller than one bin, or so large that `size / least` is more than an integer
///   can hold. (`as usize` saturates.)
///
/// Book: chapter 2, *The bins*.
fn bins_along(size: f64, least: f64, n: usize) -> usize {
    todo!("task 2.1: how many bins fit")
}
