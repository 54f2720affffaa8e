//! Sorting particles by cell: a counting sort by many threads.
//!
//! The cells are cut into *bands*. Each band counts its particles into its cells and then fetches them, so
//! no two threads write to the same memory. The order of the particles depends on neither bands nor
//! threads.

use std::ops::Range;

use pulp::{Arch, NullaryFnOnce};
use workers::Workers;

use super::grid::Grid;
use super::table::{Cells, Kind};
use crate::particles::{Bodies, make_room};
use crate::threads::{cut, pieces};

/// Particles that a band looks at together.
const PIECE: usize = 1024;
/// Particles of a band, roughly, and most bands.
const BAND: usize = 4096;
const BANDS: usize = 256;

/// What a sort needs for itself, kept from one to the next.
#[derive(Default)]
pub struct Sorter {
    /// Before a sort, room for its result; afterwards, the particles as they were before.
    pub spare: Bodies,
    /// The cell of each particle, before the sort.
    cell: Vec<u32>,
    /// Arrays of cells that are no longer needed.
    home: Vec<u32>,
    starts: Vec<u32>,
}

impl Sorter {
    /// Sorts `bodies` by the cells of `grid`. Within a cell particles keep the order they come in.
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

    /// Takes cells back, for their memory.
    pub fn take_back(&mut self, cells: Cells) {
        if let Kind::Dense { starts } = cells.kind {
            (self.starts, self.home) = (starts, cells.home);
        }
    }

    fn sort_dense(&mut self, from: &Bodies, grid: Grid, workers: &Workers) -> Cells {
        let (n, cells) = (from.len(), grid.cells() as usize);
        let (mut starts, mut home) =
            (std::mem::take(&mut self.starts), std::mem::take(&mut self.home));
        make_room(&mut starts, cells + 1);
        make_room(&mut home, n);
        make_room(&mut self.cell, n);
        let spans = locate(&mut self.cell, from, grid, workers);
        let mut bands = n.div_ceil(pieces(n, BAND, BANDS)).max(1);
        if spans.iter().all(|span| span.len() > cells / 2) {
            // Each band would look at all particles, as in the first sort of a scene.
            bands = bands.min(workers.count());
        }
        let length = cells.div_ceil(bands);
        let bands = || (0..cells).step_by(length).map(|k| Band { first: k as u32, length });
        let own = &self.cell;
        let near = |band: &Band| {
            let (band, pieces) = (*band, own.chunks(PIECE).zip(&spans).enumerate());
            pieces.filter(move |(_, (_, span))| band.meets(span)).map(|(k, (cell, _))| (k, cell))
        };

        let work = starts[1..].chunks_mut(length).zip(bands()).collect();
        let counted = workers.map(work, |(counts, band): (&mut [u32], Band)| {
            counts.fill(0);
            near(&band).for_each(|(_, cell)| band.count(cell, counts));
            counts.iter().map(|&count| count as usize).sum::<usize>()
        });
        let ends = || {
            counted.iter().scan(0, |end, count| {
                *end += count;
                Some(*end)
            })
        };
        let to = &mut self.spare;
        let work: Vec<_> = starts[1..]
            .chunks_mut(length)
            .zip(bands().zip(ends()))
            .zip(cut(&mut to.x, ends()).into_iter().zip(cut(&mut to.y, ends())))
            .zip(cut(&mut to.vx, ends()).into_iter().zip(cut(&mut to.vy, ends())))
            .zip(cut(&mut to.id, ends()).into_iter().zip(cut(&mut home, ends())))
            .collect();
        workers.map(work, |((((counts, (band, end)), (x, y)), (vx, vy)), (id, home))| {
            let mut source = vec![0; x.len()];
            to_starts(counts);
            near(&band).for_each(|(k, cell)| band.place(k * PIECE, cell, counts, &mut source));
            counts.iter_mut().for_each(|end_of_cell| *end_of_cell += (end - source.len()) as u32);
            fetch(x, &from.x, &source);
            fetch(y, &from.y, &source);
            fetch(vx, &from.vx, &source);
            fetch(vy, &from.vy, &source);
            fetch(id, &from.id, &source);
            fetch(home, own, &source);
        });
        Cells { grid, kind: Kind::Dense { starts }, home }
    }
}

/// Some cells that follow each other.
#[derive(Clone, Copy)]
struct Band {
    first: u32,
    length: usize,
}

impl Band {
    fn meets(&self, span: &Range<u32>) -> bool {
        span.start < self.first + self.length as u32 && self.first < span.end
    }

    /// Adds particles with these cells to the band's counts.
    fn count(&self, cell: &[u32], counts: &mut [u32]) {
        for cell in cell {
            if let Some(count) = counts.get_mut(cell.wrapping_sub(self.first) as usize) {
                *count += 1;
            }
        }
    }

    /// Writes the indices of particles with these cells, the first of them `start`, to where their cells'
    /// particles go.
    fn place(&self, start: usize, cell: &[u32], next: &mut [u32], source: &mut [u32]) {
        for (i, cell) in (start as u32..).zip(cell) {
            if let Some(next) = next.get_mut(cell.wrapping_sub(self.first) as usize) {
                source[*next as usize] = i;
                *next += 1;
            }
        }
    }
}

/// From numbers of particles to where their cells start.
fn to_starts(counts: &mut [u32]) {
    let mut start = 0;
    for count in counts {
        start += std::mem::replace(count, start);
    }
}

/// `to[k] = from[source[k]]`.
fn fetch<T: Copy>(to: &mut [T], from: &[T], source: &[u32]) {
    for (to, &i) in to.iter_mut().zip(source) {
        *to = from[i as usize];
    }
}

/// Finds the cell of each particle, and for each piece the cells that it spans.
fn locate(cell: &mut [u32], from: &Bodies, grid: Grid, workers: &Workers) -> Vec<Range<u32>> {
    let arch = Arch::new();
    let long = PIECE * cell.len().div_ceil(PIECE).div_ceil(BANDS);
    let work = cell.chunks_mut(long).enumerate().collect();
    let spans = workers.map(work, |(k, cell): (usize, &mut [u32])| {
        arch.dispatch(Locate { cell, bodies: from, first: k * long, grid });
        let span = |cell: &[u32]| {
            let (least, most) = cell.iter().fold((u32::MAX, 0), |(a, b), &c| (a.min(c), b.max(c)));
            least..most + 1
        };
        cell.chunks(PIECE).map(span).collect::<Vec<_>>()
    });
    spans.into_iter().flatten().collect()
}

/// The cells of consecutive particles.
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
        let (x, y) = (&bodies.x[range.clone()], &bodies.y[range]);
        for ((cell, x), y) in cell.iter_mut().zip(x).zip(y) {
            *cell = grid.row(*y) * grid.columns + grid.column(*x);
        }
    }
}

/// Sorts `from` into `to` by the cells of `grid`. Only occupied cells are stored.
fn sort_sparse(from: &Bodies, to: &mut Bodies, grid: Grid) -> Cells {
    let key = |i: usize| {
        u64::from(grid.row(from.y[i])) * u64::from(grid.columns) + u64::from(grid.column(from.x[i]))
    };
    let mut order: Vec<(u64, u32)> = (0..from.len()).map(|i| (key(i), i as u32)).collect();
    order.sort_unstable();
    let (mut keys, mut starts, mut home) = (Vec::new(), Vec::new(), Vec::new());
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
