//! Task 2.8: all bins in one array.

use std::mem;
use std::ops::Range;

use common::Vec2;
use common::soft::{Observer, Particle};

use crate::{Gather, Grid};

/// Particles in the order of their bins, one bin after the other in one array.
///
/// `starts[b]` is where bin b begins, and where bin b − 1 ends; one more entry marks the end of
/// the last. The bins of a row follow each other, so three neighbouring bins of a row are one
/// slice, and what a particle has to look at is three slices.
///
/// It covers the rows `rows` of a grid: all of them, or the rows of a process and one on either
/// side for the ghosts of its neighbours. Rows are always counted as in the whole grid.
#[derive(Debug, Default)]
pub struct SortedBins {
    grid: Grid,
    rows: Range<usize>,
    starts: Vec<u32>,
    particles: Vec<Particle>,
    unsorted: Vec<Particle>,
}

impl SortedBins {
    /// Empty bins for the rows `rows` of `grid`.
    pub fn new(grid: Grid, rows: Range<usize>) -> Self {
        let bins = rows.len() * grid.columns();
        let starts = vec![0; bins + 1];
        Self { grid, rows, starts, particles: Vec::new(), unsorted: Vec::new() }
    }

    /// Replaces the particles by new ones, all of which lie in these rows.
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

    /// All particles, to be moved, added or taken away. Then [`sort`](Self::sort) them.
    #[inline]
    pub fn particles_mut(&mut self) -> &mut Vec<Particle> {
        &mut self.particles
    }

    /// Takes out the particle at `index`; the last one fills the gap. Then [`sort`](Self::sort).
    pub fn take(&mut self, index: usize) -> Particle {
        self.particles.swap_remove(index)
    }

    /// Adds a particle that lies in these rows. Then [`sort`](Self::sort).
    pub fn put(&mut self, particle: Particle) {
        self.particles.push(particle);
    }

    /// Which indices of [`particles`](Self::particles) belong to `rows`.
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

    /// Which indices of [`particles`](Self::particles) belong to some neighbouring bins of a row.
    #[inline]
    pub fn span(&self, row: usize, columns: Range<usize>) -> Range<usize> {
        let first = (row - self.rows.start) * self.grid.columns();
        let (start, end) = (self.starts[first + columns.start], self.starts[first + columns.end]);
        start as usize..end as usize
    }

    /// Brings the particles into the order of the bins that they lie in now, by counting sort.
    ///
    /// First count the particles of each bin; then sum the counts, so that each bin knows where
    /// it ends; then put each particle into the last free index of its bin, and let the bin end
    /// one index earlier. When all are copied, what was the end of a bin is its start. The particles
    /// of a bin must keep their order: so go through all from the last to the first.
    ///
    /// Particles move little in a time step: they are nearly sorted already, so that reading and
    /// writing both go through memory nearly in order.
    ///
    /// Book: chapter 2, *Sorted*.
    pub fn sort(&mut self) {
        mem::swap(&mut self.particles, &mut self.unsorted);
        self.particles.resize(self.unsorted.len(), Particle::default());
        let (grid, offset) = (self.grid, self.rows.start * self.grid.columns());
        let bin_of = |particle: &Particle| grid.bin(particle) - offset;
        todo!("task 2.8: counting sort")
    }

    /// Sums the forces on all particles of `rows` into `accelerations`, which has an entry for
    /// each of their [`indices`](Self::indices).
    ///
    /// The rows next to `rows` are read. Different rows can be summed at the same time.
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

    /// The three slices that hold all particles that can be within the cutoff of `particle`.
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
