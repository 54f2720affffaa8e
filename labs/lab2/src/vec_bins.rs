//! Tasks 2.3 and 2.4: a list of particles for each bin.

use std::slice;

use common::Vec2;
use common::soft::{Observer, Particle, Scene};
use solution1::add_pair;

use crate::Grid;

/// Bins that each own a `Vec` of their particles.
///
/// A `Vec` keeps its memory when it is cleared, so after a few steps the bins allocate no more memory.
#[derive(Debug, Default)]
pub struct VecBins {
    grid: Grid,
    bins: Vec<Vec<Particle>>,
}

impl VecBins {
    /// Makes empty bins.
    pub fn new(grid: Grid) -> Self {
        Self { grid, bins: vec![Vec::new(); grid.bins()] }
    }

    /// Makes empty bins, each at least `bin_size` cutoffs wide, for the box of `scene`.
    pub fn of_scene(scene: &Scene, bin_size: f64) -> Self {
        Self::new(Grid::of_scene(scene, bin_size))
    }

    /// The geometry of the bins.
    #[inline]
    pub fn grid(&self) -> &Grid {
        &self.grid
    }

    /// The bins, row by row.
    #[inline]
    pub fn bins(&self) -> &[Vec<Particle>] {
        &self.bins
    }

    /// The bins, row by row, as a mutable slice. `chunks_mut(columns)` yields the rows.
    #[inline]
    pub fn bins_mut(&mut self) -> &mut [Vec<Particle>] {
        &mut self.bins
    }

    /// All particles, bin by bin.
    pub fn particles(&self) -> impl Iterator<Item = &Particle> {
        self.bins.iter().flatten()
    }

    /// Adds a particle to the bin that contains its position. A bin takes any number of particles.
    ///
    /// Book: chapter 2, *Rebuild*.
    #[inline]
    pub fn put(&mut self, particle: Particle) {
        todo!("task 2.3: a particle goes into its bin")
    }

    /// Empties all bins and puts `particles` into them. Each bin keeps its memory.
    ///
    /// Book: chapter 2, *Rebuild*.
    pub fn refill(&mut self, particles: &[Particle]) {
        todo!("task 2.3b: clear and fill again")
    }

    /// Returns the acceleration of `particle` due to the particles in its bin and in the bins
    /// around it.
    ///
    /// - Start the sum at zero, and add the neighbours' contributions in the order in which you find
    ///   the neighbours.
    /// - The rows and columns of [`Grid::near`] contain nine bins, or fewer at a wall. Visit each
    ///   bin once.
    /// - The particle's own bin contains the particle itself, which adds zero.
    /// - For each bin, report the number of particles tested to `observer` (`tested`, a `u64`). The
    ///   particle itself counts too. `add_pair` reports the pairs within the cutoff.
    ///
    /// Book: chapter 2, *Nine bins*.
    #[inline]
    pub fn acceleration<O: Observer>(&self, particle: &Particle, observer: &mut O) -> Vec2 {
        todo!("task 2.4: the force on a particle from nine bins")
    }
}

impl<'a> IntoIterator for &'a VecBins {
    type Item = &'a Vec<Particle>;
    type IntoIter = slice::Iter<'a, Vec<Particle>>;

    fn into_iter(self) -> Self::IntoIter {
        self.bins.iter()
    }
}
