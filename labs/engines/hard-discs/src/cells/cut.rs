//! Divides the rows of cells into strips with about the same number of discs each.

use std::ops::Range;

use common::hard::Disc;

use super::lattice::Lattice;

/// Approximate number of discs in a strip.
///
/// The entries of this many discs stay in a core's nearest caches while they are sorted and
/// searched.
const DISCS: usize = 512;

/// Greatest number of strips. A worker fills a list for each strip, and more lists would not fit
/// into its caches.
const MOST_STRIPS: usize = 512;

/// Greatest number of slices; a slice is 2^k rows that stay together.
const MOST_SLICES: u32 = 4096;

/// Number of discs that are sampled to estimate the positions of all discs.
const SAMPLE: usize = 1 << 14;

/// A lattice whose rows are divided into strips with about the same number of discs each.
///
/// The strips depend on the discs but not on the number of workers, because each worker takes one
/// strip after another until no strip is left.
#[derive(Debug)]
pub(super) struct Cut {
    /// The lattice.
    pub(super) lattice: Lattice,
    shift: u32,
    /// The strip of each slice.
    strips: Vec<u32>,
    /// The rows of each strip.
    rows: Vec<Range<u32>>,
}

impl Cut {
    /// Divides the rows of a lattice into strips.
    pub(super) fn new(lattice: Lattice, discs: &[Disc]) -> Self {
        let mut shift = 0;
        while lattice.rows() >> shift >= MOST_SLICES {
            shift += 1;
        }
        // If there are no discs, there are no rows.
        let slices = (lattice.rows().saturating_sub(1) >> shift) + 1;
        let mut sampled = vec![0_usize; slices as usize];
        for disc in discs.iter().step_by(discs.len().div_ceil(SAMPLE).max(1)) {
            sampled[(lattice.row(disc.y) >> shift) as usize] += 1;
        }

        let wanted = (discs.len() / DISCS).clamp(1, MOST_STRIPS);
        let all: usize = sampled.iter().sum();
        let mut strips = Vec::with_capacity(sampled.len());
        let mut rows = Vec::new();
        let mut below = 0;
        let mut start = 0;
        for (slice, discs) in sampled.into_iter().enumerate() {
            strips.push(rows.len() as u32);
            below += discs;
            let end = lattice.rows().min((slice as u32 + 1) << shift);
            if below * wanted >= (rows.len() + 1) * all || end == lattice.rows() {
                rows.push(start..end);
                start = end;
            }
        }
        Self { lattice, shift, strips, rows }
    }

    /// Returns the strip that contains a row.
    #[inline]
    pub(super) fn strip(&self, row: u32) -> usize {
        self.strips[(row >> self.shift) as usize] as usize
    }

    /// Returns the number of strips.
    pub(super) fn strips(&self) -> usize {
        self.rows.len()
    }

    /// Returns the numbers of the cells of a strip.
    pub(super) fn cells(&self, strip: usize) -> Range<u64> {
        let Range { start, end } = self.rows[strip];
        self.lattice.cell(start, 0)..self.lattice.cell(end, 0)
    }
}
