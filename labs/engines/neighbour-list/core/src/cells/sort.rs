//! Sorts particles by cell, so that neighbours in the box become neighbours in memory.
//!
//! If few cells are empty, many threads run a counting sort. An example with eight particles, four
//! cells and two bands:
//!
//! ```text
//! before    particle     a b c d e f g h
//! locate    its cell     2 0 3 1 0 2 3 0
//!                        band of cells 0 and 1     band of cells 2 and 3
//! count     particles    3 1, together 4           2 2, together 4
//! ends      of bands     4                         8
//! fill      particles    b e h d                   a f c g
//! ```
//!
//! Each band knows its part of the result from the ends, so the threads need no lock. Within a cell
//! particles keep their order.
//!
//! If most cells are empty, pairs of cell and particle are sorted, and only occupied cells are
//! stored.

use std::ops::Range;

use pulp::{Arch, NullaryFnOnce};
use workers::Workers;

use super::bands::{Band, Located, PIECE};
use super::grid::Grid;
use super::table::{Cells, Kind};
use crate::particles::{Bodies, make_room};
use crate::threads::{cut, pieces};

/// Approximate number of particles in a band.
const BAND: usize = 4096;
/// Greatest number of bands.
const BANDS: usize = 256;

/// The memory of a sort, kept for the next sort.
#[derive(Default)]
pub struct Sorter {
    /// The memory for the next result. After a sort it contains the particles in their order before
    /// that sort.
    pub spare: Bodies,
    /// The cell of each particle, in the order before the sort.
    cell: Vec<u32>,
    /// Arrays of former [`Cells`], kept for their memory.
    home: Vec<u32>,
    starts: Vec<u32>,
}

impl Sorter {
    /// Sorts `bodies` by cell of `grid`. Within a cell particles keep their order.
    pub fn sort(&mut self, bodies: &mut Bodies, grid: Grid, workers: &Workers) -> Cells {
        self.spare.resize(bodies.len());
        let cells = if grid.is_dense(bodies.len()) {
            self.sort_dense(bodies, grid, workers)
        } else {
            sort_sparse(bodies, &mut self.spare, grid)
        };
        std::mem::swap(bodies, &mut self.spare);
        cells
    }

    /// Keeps the arrays of `cells` as memory for the next sort. `cells` is no longer needed.
    pub fn take_back(&mut self, cells: Cells) {
        if let Kind::Dense { starts } = cells.kind {
            self.starts = starts;
            self.home = cells.home;
        }
    }

    fn sort_dense(&mut self, from: &Bodies, grid: Grid, workers: &Workers) -> Cells {
        let n = from.len();
        let cells = grid.cells() as usize;
        let mut starts = std::mem::take(&mut self.starts);
        let mut home = std::mem::take(&mut self.home);
        make_room(&mut starts, cells + 1);
        make_room(&mut home, n);
        make_room(&mut self.cell, n);
        let spans = locate(&mut self.cell, from, grid, workers);
        let mut count = n.div_ceil(pieces(n, BAND, BANDS)).max(1);
        if spans.iter().all(|span| span.len() > cells / 2) {
            // In the first sort of a scene, particles of all cells are in every piece. Each band
            // then reads all particles, so there are no more bands than threads.
            count = count.min(workers.count());
        }
        let located = Located { cell: &self.cell, spans };
        let mut bands = Band::of_cells(&mut starts[1..], cells.div_ceil(count));
        let counted =
            workers.map(bands.iter_mut().collect(), |band: &mut Band<'_>| band.count(&located));
        let ends = running_ends(&counted);
        for (band, to) in bands.iter_mut().zip(self.spare.split(&ends)) {
            band.to = to;
        }
        for (band, home) in bands.iter_mut().zip(cut(&mut home, &ends)) {
            band.home = home;
        }
        workers.map(bands.into_iter().zip(ends).collect(), |(band, end): (Band<'_>, usize)| {
            band.fill(end, from, &located);
        });
        Cells { grid, kind: Kind::Dense { starts }, home }
    }
}

/// Returns the end of each run, if runs of these lengths follow one another from 0 on.
fn running_ends(lengths: &[usize]) -> Vec<usize> {
    let mut end = 0;
    let mut ends = Vec::with_capacity(lengths.len());
    for length in lengths {
        end += length;
        ends.push(end);
    }
    ends
}

/// Writes the cell of each particle to `cell`. Returns the range of cells of each piece.
fn locate(cell: &mut [u32], from: &Bodies, grid: Grid, workers: &Workers) -> Vec<Range<u32>> {
    let arch = Arch::new();
    let long = PIECE * cell.len().div_ceil(PIECE).div_ceil(BANDS);
    let work = cell.chunks_mut(long).enumerate().collect();
    let spans = workers.map(work, |(k, cell): (usize, &mut [u32])| {
        arch.dispatch(Locate { cell, bodies: from, first: k * long, grid });
        cell.chunks(PIECE).map(span).collect::<Vec<_>>()
    });
    spans.into_iter().flatten().collect()
}

/// Returns the range from the least to the greatest of these cells.
fn span(cell: &[u32]) -> Range<u32> {
    let (least, most) = cell.iter().fold((u32::MAX, 0), |(a, b), &c| (a.min(c), b.max(c)));
    least..most + 1
}

/// A vector kernel that computes the cells of the particles from `first` on.
struct Locate<'a> {
    cell: &'a mut [u32],
    bodies: &'a Bodies,
    first: usize,
    grid: Grid,
}

impl NullaryFnOnce for Locate<'_> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        let Self { cell, bodies, first, grid } = self;
        let range = first..first + cell.len();
        let positions = bodies.x[range.clone()].iter().zip(&bodies.y[range]);
        for (cell, (x, y)) in cell.iter_mut().zip(positions) {
            *cell = grid.row(*y) * grid.columns + grid.column(*x);
        }
    }
}

/// Sorts `from` into `to` by cell of `grid`, and stores only the occupied cells.
fn sort_sparse(from: &Bodies, to: &mut Bodies, grid: Grid) -> Cells {
    let key = |i: usize| {
        u64::from(grid.row(from.y[i])) * u64::from(grid.columns) + u64::from(grid.column(from.x[i]))
    };
    let mut order: Vec<(u64, u32)> = (0..from.len()).map(|i| (key(i), i as u32)).collect();
    order.sort_unstable();
    let mut keys = Vec::new();
    let mut starts = Vec::new();
    let mut home = Vec::new();
    for (k, &(key, i)) in order.iter().enumerate() {
        if keys.last() != Some(&key) {
            keys.push(key);
            starts.push(k as u32);
        }
        home.push(keys.len() as u32 - 1);
        to.set(k, from.get(i as usize));
    }
    starts.push(order.len() as u32);
    Cells { grid, kind: Kind::Sparse { keys, starts }, home }
}
