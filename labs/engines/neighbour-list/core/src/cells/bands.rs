//! Bands of cells. Each band is sorted on its own.
//!
//! A band counts its particles into its cells and then fetches them, so no two threads write to the same memory. The order
//! of the particles depends on neither bands nor threads.

use std::ops::Range;

use crate::particles::{Bodies, Moving};

/// Particles that a band looks at together.
pub(super) const PIECE: usize = 1024;

/// The cells of all particles, in their order before the sort.
pub(super) struct Located<'a> {
    pub(super) cell: &'a [u32],
    /// For each piece the range of its cells.
    pub(super) spans: Vec<Range<u32>>,
}

impl Located<'_> {
    /// The pieces that may have particles in `cells`: the index of a piece's first particle, and its cells.
    fn among(&self, cells: Range<u32>) -> impl Iterator<Item = (usize, &[u32])> {
        let pieces = (0..).step_by(PIECE).zip(self.cell.chunks(PIECE)).zip(&self.spans);
        let near = pieces.filter(move |(_, span)| span.start < cells.end && cells.start < span.end);
        near.map(|(piece, _)| piece)
    }
}

/// Consecutive cells, and the room for their particles.
#[derive(Default)]
pub(super) struct Band<'a> {
    /// The first cell.
    first: u32,
    /// For each cell the number of its particles, and later the index at which they end.
    counts: &'a mut [u32],
    pub(super) to: Moving<'a>,
    pub(super) home: &'a mut [u32],
}

impl<'a> Band<'a> {
    /// Bands of `length` cells each. `counts` has an entry for each cell.
    pub(super) fn of_cells(counts: &'a mut [u32], length: usize) -> Vec<Self> {
        let bands = (0..).step_by(length).zip(counts.chunks_mut(length));
        bands.map(|(first, counts)| Self { first, counts, ..Self::default() }).collect()
    }

    fn cells(&self) -> Range<u32> {
        self.first..self.first + self.counts.len() as u32
    }

    /// Counts the particles in each cell, and returns the number of all.
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

    /// Fetches the particles in the order of the cells. They are to end at index `end` of all particles. The numbers of
    /// particles become the ends of cells.
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

    /// The indices of the band's particles before the sort, cell by cell. The numbers of particles become the ends of
    /// cells among them.
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

/// Replaces the numbers of particles by the indices at which their cells start.
fn to_starts(counts: &mut [u32]) {
    let mut start = 0;
    for count in counts {
        start += std::mem::replace(count, start);
    }
}

/// Copies: `to[k] = from[source[k]]`.
fn fetch<T: Copy>(to: &mut [T], from: &[T], source: &[u32]) {
    for (to, &i) in to.iter_mut().zip(source) {
        *to = from[i as usize];
    }
}
