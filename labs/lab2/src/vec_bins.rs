//! Tasks 2.3 and 2.4: a list of particles for each bin.

use std::slice;

use common::Vec2;
use common::soft::{Observer, Particle, Scene};
use solution1::add_pair;

use crate::Grid;

/// Bins that each own a `Vec` of the particles in it.
///
/// A `Vec` remembers its memory when it is cleared, so that after a few steps nothing is allocated
/// any more.
#[derive(Debug, Default)]
pub struct VecBins {
    grid: Grid,
    bins: Vec<Vec<Particle>>,
}

impl VecBins {
    /// Empty bins.
    pub fn new(grid: Grid) -> Self {
        Self { grid, bins: vec![Vec::new(); grid.bins()] }
    }

    /// Bins of `bin_size` cutoffs or more for the box of `scene`, still empty.
    pub fn of_scene(scene: &Scene, bin_size: f64) -> Self {
        Self::new(Grid::of_scene(scene, bin_size))
    }

    /// The geometry.
    #[inline]
    pub fn grid(&self) -> &Grid {
        &self.grid
    }

    /// The bins, row by row.
    #[inline]
    pub fn bins(&self) -> &[Vec<Particle>] {
        &self.bins
    }

    /// The bins, row by row, to be changed: `chunks_mut(columns)` gives the rows.
    #[inline]
    pub fn bins_mut(&mut self) -> &mut [Vec<Particle>] {
        &mut self.bins
    }

    /// All particles, bin by bin.
    pub fn particles(&self) -> impl Iterator<Item = &Particle> {
        self.bins.iter().flatten()
    }

    /// Puts a particle into the bin that it lies in, however many are there already.
    ///
    /// Book: chapter 2, *Rebuild*.
    #[inline]
    pub fn put(&mut self, particle: Particle) {
        todo!("task 2.3: a particle goes into its bin")
    }

    /// Forgets what the bins hold and puts `particles` into them. Each bin keeps its memory.
    ///
    /// Book: chapter 2, *Rebuild*.
    pub fn refill(&mut self, particles: &[Particle]) {
        todo!("task 2.3b: clear and fill again")
    }

    /// What the particles in the bin of `particle` and in the bins around it do to it, summed in
    /// the order in which they are found. `observer` is told how many particles were looked at
    /// (`tested`), a number of type `u64`; the particle itself counts as one. `add_pair` tells it which were within
    /// the cutoff.
    ///
    /// The particle itself is among those in its bin; it does nothing to itself. With
    /// [`Grid::near`] there are up to nine bins, less at a wall, and each counts once.
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
