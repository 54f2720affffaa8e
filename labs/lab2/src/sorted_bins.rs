//! Task 2.8: all bins in one array.

use std::mem;
use std::ops::Range;

use common::Vec2;
use common::soft::{Observer, Particle};

use crate::{Gather, Grid};

/// Particles in the order of their bins, one bin after the other in one array.
///
/// Bin b begins at `starts[b]`, where bin b − 1 ends. One more entry marks the end of the last bin.
/// The bins of a row follow each other in memory. So three neighbouring bins of a row are one slice,
/// and the nine bins around a particle are three slices.
///
/// The bins cover the rows `rows` of a grid. These are either all rows, or the rows of a process and
/// one more row on either side for ghosts. Rows are numbered as in the whole grid.
#[derive(Debug, Default)]
pub struct SortedBins {
    grid: Grid,
    rows: Range<usize>,
    starts: Vec<u32>,
    particles: Vec<Particle>,
    unsorted: Vec<Particle>,
}

impl SortedBins {
    /// Makes empty bins for the rows `rows` of `grid`.
    pub fn new(grid: Grid, rows: Range<usize>) -> Self {
        let bins = rows.len() * grid.columns();
        let starts = vec![0; bins + 1];
        Self { grid, rows, starts, particles: Vec::new(), unsorted: Vec::new() }
    }

    /// Replaces all particles. The new particles must be in the rows of these bins.
    pub fn refill(&mut self, particles: impl IntoIterator<Item = Particle>) {
        self.particles.clear();
        self.particles.extend(particles);
        self.sort();
    }

    /// The geometry of the whole box.
    #[inline]
    pub fn grid(&self) -> &Grid {
        &self.grid
    }

    /// The rows that these bins cover.
    pub fn rows(&self) -> Range<usize> {
        self.rows.clone()
    }

    /// All particles, in the order of their bins at the last sort.
    #[inline]
    pub fn particles(&self) -> &[Particle] {
        &self.particles
    }

    /// All particles, to be moved, added or removed. Call [`sort`](Self::sort) afterwards.
    #[inline]
    pub fn particles_mut(&mut self) -> &mut Vec<Particle> {
        &mut self.particles
    }

    /// Removes the particle at `index`; the last particle fills the gap. Call [`sort`](Self::sort)
    /// afterwards.
    pub fn take(&mut self, index: usize) -> Particle {
        self.particles.swap_remove(index)
    }

    /// Adds a particle, which must be in the rows of these bins. Call [`sort`](Self::sort)
    /// afterwards.
    pub fn put(&mut self, particle: Particle) {
        self.particles.push(particle);
    }

    /// The range of indices in [`particles`](Self::particles) that belongs to `rows`.
    #[inline]
    pub fn indices(&self, rows: Range<usize>) -> Range<usize> {
        let start = (rows.start - self.rows.start) * self.grid.columns();
        let end = (rows.end - self.rows.start) * self.grid.columns();
        self.starts[start] as usize..self.starts[end] as usize
    }

    /// The particles of one bin.
    #[inline]
    pub fn bin(&self, row: usize, column: usize) -> &[Particle] {
        self.bins(row, column..column + 1)
    }

    /// The particles of some neighbouring bins of a row.
    #[inline]
    pub fn bins(&self, row: usize, columns: Range<usize>) -> &[Particle] {
        &self.particles[self.span(row, columns)]
    }

    /// The range of indices in [`particles`](Self::particles) that belongs to neighbouring bins of a row.
    #[inline]
    pub fn span(&self, row: usize, columns: Range<usize>) -> Range<usize> {
        let first = (row - self.rows.start) * self.grid.columns();
        let (start, end) = (self.starts[first + columns.start], self.starts[first + columns.end]);
        start as usize..end as usize
    }

    /// Sorts the particles by the bins that contain them now, with a counting sort.
    ///
    /// 1. Count the particles of each bin.
    /// 2. Add up the counts, so that the entry of each bin is the index at which it ends.
    /// 3. Go through the particles from the last to the first. Move the end of the particle's bin down by
    ///    one index, and copy the particle there. Because the loop runs backwards, the particles of a bin
    ///    keep their order.
    ///
    /// After the last copy, each entry is the start of its bin.
    ///
    /// Particles move little in a time step, so they are nearly sorted already. Reads and writes
    /// therefore go through memory nearly in order.
    ///
    /// Book: chapter 2, *Sorted*.
    pub fn sort(&mut self) {
        mem::swap(&mut self.particles, &mut self.unsorted);
        self.particles.resize(self.unsorted.len(), Particle::default());
        let (grid, offset) = (self.grid, self.rows.start * self.grid.columns());
        let bin_of = |particle: &Particle| grid.bin(particle) - offset;
        todo!("task 2.8: counting sort")
    }

    /// Computes the accelerations of all particles of `rows` into `accelerations`.
    ///
    /// `accelerations` has one entry for each of the [`indices`](Self::indices) of `rows`. The function
    /// also reads the rows next to `rows`. Threads can compute different rows at the same time.
    pub fn gather_rows<O: Observer>(
        &self,
        rows: Range<usize>,
        accelerations: &mut [Vec2],
        gather: &mut Gather,
        observer: &mut O,
    ) {
        let particles = &self.particles[self.indices(rows)];
        for (particle, a) in particles.iter().zip(accelerations) {
            *a = gather.acceleration(particle, self.around(particle), observer);
        }
    }

    /// The three slices that contain all particles that can be within the cutoff of `particle`.
    #[inline]
    pub fn around(&self, particle: &Particle) -> [&[Particle]; 3] {
        let columns = self.grid.near(self.grid.column(particle.x));
        let mut slices = [&[][..]; 3];
        let rows = self.grid.near(self.grid.row(particle.y));
        for (row, slice) in rows.zip(&mut slices) {
            *slice = self.bins(row, columns.clone());
        }
        slices
    }
}
