//! Bands are ranges of consecutive cells; one thread at a time sorts a band.
//!
//! A band first counts the particles of its cells and then copies them into its own part of the
//! result. So no two threads write to the same memory. The order of the particles depends neither
//! on the bands nor on the threads. The whole sort, with a drawing, is in [`sort`](super::sort).

use std::ops::Range;

use crate::particles::{Bodies, Moving};

/// Number of particles whose range of cells is stored, so that a band can skip all of them
/// together.
pub(super) const PIECE: usize = 1024;

/// The cell of each particle, in the order before the sort.
pub(super) struct Located<'a> {
    pub(super) cell: &'a [u32],
    /// The range of cells of each piece of [`PIECE`] particles.
    pub(super) spans: Vec<Range<u32>>,
}

impl Located<'_> {
    /// Returns the pieces that may have particles in `cells`.
    ///
    /// An item is the index of the piece's first particle, and the cells of all its particles.
    fn among(&self, cells: Range<u32>) -> impl Iterator<Item = (usize, &[u32])> {
        let pieces = (0..).step_by(PIECE).zip(self.cell.chunks(PIECE)).zip(&self.spans);
        let near = pieces.filter(move |(_, span)| span.start < cells.end && cells.start < span.end);
        near.map(|(piece, _)| piece)
    }
}

/// Consecutive cells, and the memory for their sorted particles.
#[derive(Default)]
pub(super) struct Band<'a> {
    /// The number of the band's first cell.
    first: u32,
    /// The number of particles in each cell; after [`fill`](Self::fill), the index at which the
    /// cell ends.
    counts: &'a mut [u32],
    pub(super) to: Moving<'a>,
    pub(super) home: &'a mut [u32],
}

impl<'a> Band<'a> {
    /// Divides the cells into bands of `length` cells each. `counts` has an entry for each cell.
    pub(super) fn of_cells(counts: &'a mut [u32], length: usize) -> Vec<Self> {
        let bands = (0..).step_by(length).zip(counts.chunks_mut(length));
        bands.map(|(first, counts)| Self { first, counts, ..Self::default() }).collect()
    }

    fn cells(&self) -> Range<u32> {
        self.first..self.first + self.counts.len() as u32
    }

    /// Counts the particles in each cell and returns the total.
    pub(super) fn count(&mut self, located: &Located<'_>) -> usize {
        let pieces = located.among(self.cells());
        let Self { first, counts, .. } = self;
        counts.fill(0);
        for (_, cell) in pieces {
            for cell in cell {
                if let Some(count) = counts.get_mut(cell.wrapping_sub(*first) as usize) {
                    *count += 1;
                }
            }
        }
        counts.iter().map(|&count| count as usize).sum()
    }

    /// Copies the band's particles from `from`, cell by cell, to the indices before `end`.
    ///
    /// Afterwards `counts` contains the index at which each cell ends.
    pub(super) fn fill(mut self, end: usize, from: &Bodies, located: &Located<'_>) {
        let source = self.sources(located);
        let start = (end - source.len()) as u32;
        self.counts.iter_mut().for_each(|end_of_cell| *end_of_cell += start);
        fetch(self.to.x, &from.x, &source);
        fetch(self.to.y, &from.y, &source);
        fetch(self.to.vx, &from.vx, &source);
        fetch(self.to.vy, &from.vy, &source);
        fetch(self.to.id, &from.id, &source);
        fetch(self.home, located.cell, &source);
    }

    /// Returns the indices that the band's particles had before the sort, cell by cell.
    ///
    /// Afterwards `counts` contains the end of each cell, counted from the band's first particle.
    fn sources(&mut self, located: &Located<'_>) -> Vec<u32> {
        let pieces = located.among(self.cells());
        let Self { first, counts, home, .. } = self;
        let mut source = vec![0; home.len()];
        to_starts(counts);
        for (start, cell) in pieces {
            for (i, cell) in (start as u32..).zip(cell) {
                if let Some(next) = counts.get_mut(cell.wrapping_sub(*first) as usize) {
                    source[*next as usize] = i;
                    *next += 1;
                }
            }
        }
        source
    }
}

/// Replaces the number of particles of each cell by the index at which the cell starts.
fn to_starts(counts: &mut [u32]) {
    let mut start = 0;
    for count in counts {
        start += std::mem::replace(count, start);
    }
}

/// Sets `to[k] = from[source[k]]` for every k.
fn fetch<T: Copy>(to: &mut [T], from: &[T], source: &[u32]) {
    for (to, &i) in to.iter_mut().zip(source) {
        *to = from[i as usize];
    }
}
