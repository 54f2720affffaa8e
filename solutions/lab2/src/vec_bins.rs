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
// ANCHOR: vec_bins
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
    // ANCHOR_END: vec_bins

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
        // task 2.3: a particle goes into its bin
        self.bins[self.grid.bin(&particle)].push(particle);
        // end 2.3
    }

    /// Forgets what the bins hold and puts `particles` into them. Each bin keeps its memory.
    ///
    /// Book: chapter 2, *Rebuild*.
    pub fn refill(&mut self, particles: &[Particle]) {
        // task 2.3b: clear and fill again
        for bin in &mut self.bins {
            bin.clear();
        }
        for particle in particles {
            self.put(*particle);
        }
        // end 2.3b
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
        // task 2.4: the force on a particle from nine bins
        let mut a = Vec2::ZERO;
        for row in self.grid.near(self.grid.row(particle.y)) {
            for column in self.grid.near(self.grid.column(particle.x)) {
                let bin = &self.bins[row * self.grid.columns() + column];
                observer.tested(bin.len() as u64);
                for neighbour in bin {
                    add_pair(&mut a, particle.to(neighbour), observer);
                }
            }
        }
        a
        // end 2.4
    }

    // answer only
    /// The bins around `particle`, for later labs: all bins that can hold a neighbour, as [`Gather`] takes
    /// them. Here it would be the answer to task 2.4.
    ///
    /// [`Gather`]: crate::Gather
    #[inline]
    pub fn around(&self, particle: &Particle) -> impl Iterator<Item = &[Particle]> {
        let columns = self.grid.near(self.grid.column(particle.x));
        let rows = self.grid.near(self.grid.row(particle.y));
        rows.flat_map(move |row| {
            let first = row * self.grid.columns();
            self.bins[first + columns.start..first + columns.end].iter().map(Vec::as_slice)
        })
    }
    // end answer only
}

impl<'a> IntoIterator for &'a VecBins {
    type Item = &'a Vec<Particle>;
    type IntoIter = slice::Iter<'a, Vec<Particle>>;

    fn into_iter(self) -> Self::IntoIter {
        self.bins.iter()
    }
}
