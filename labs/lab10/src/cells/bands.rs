//! Bands of rows of cells: a coarse sort, before the sort by cell.
//!
//! Piece by piece of the order in which particles come, each piece is put in the order of its bands.

use pulp::{Arch, NullaryFnOnce};

use super::grid::Grid;
use crate::particles::{Bodies, make_room};
use crate::threads::{LEAST, Workers, pieces};

/// Most pieces, and most bands.
const MOST: usize = 256;

/// A piece that has particles of more bands is scattered over more memory than a cache holds. Measured on
/// the machine of the book.
const SCATTERED: usize = 100;

/// Which particles belong to which band.
#[derive(Default)]
pub(super) struct Bands {
    /// The cell of each particle.
    pub(super) cell: Vec<u32>,
    /// Piece by piece, its particles in the order of their bands.
    order: Vec<u32>,
    /// For each piece, where each band begins in its order, and the end of the last.
    bounds: Vec<Vec<u32>>,
    /// Particles of a piece, but for the last.
    piece: usize,
    /// Cells of a band, but for the last.
    pub(super) cells: usize,
}

impl Bands {
    /// Finds the cell and the band of each particle.
    pub(super) fn find(&mut self, bodies: &Bodies, grid: Grid, workers: &Workers) {
        let (n, rows) = (bodies.len(), grid.rows as usize);
        self.piece = pieces(n, LEAST, MOST);
        let band_rows = rows.div_ceil(n.div_ceil(self.piece).min(rows));
        self.cells = band_rows * grid.columns as usize;
        make_room(&mut self.cell, n);
        make_room(&mut self.order, n);
        let (piece, cells, bands) = (self.piece, self.cells, rows.div_ceil(band_rows));
        let work =
            self.cell.chunks_mut(piece).zip(self.order.chunks_mut(piece)).enumerate().collect();
        let arch = Arch::new();
        self.bounds = workers.map(work, |(k, (cell, order)): (usize, (&mut [u32], &mut [u32]))| {
            let first = k * piece;
            arch.dispatch(Locate { cell, bodies, first, grid });
            order_by_band(cell, order, first, cells, bands)
        });
    }

    /// Where each band ends in the new order.
    pub(super) fn ends(&self) -> Vec<usize> {
        let bands = 1..self.bounds.first().map_or(1, Vec::len);
        let end = |band: usize| self.bounds.iter().map(|bounds| bounds[band] as usize).sum();
        bands.map(end).collect()
    }

    /// The particles of a band, piece by piece.
    pub(super) fn runs(&self, band: usize) -> impl Iterator<Item = &[u32]> {
        let pieces = self.order.chunks(self.piece).zip(&self.bounds);
        pieces.map(move |(order, bounds)| &order[bounds[band] as usize..bounds[band + 1] as usize])
    }

    /// Whether a band's particles come from all over memory, as in the first sort of a large scene.
    pub(super) fn are_scattered(&self) -> bool {
        let runs = |bounds: &Vec<u32>| bounds.windows(2).filter(|ends| ends[0] < ends[1]).count();
        self.bounds.iter().map(runs).sum::<usize>() > SCATTERED * self.bounds.len()
    }

    /// Writes the particles of `from`, whose bands have been found, into `to`, band by band. There they
    /// have to be found anew. They are read in order and written behind the last of their bands, so no
    /// particle is waited for alone.
    pub(super) fn spread(&mut self, from: &Bodies, to: &mut Bodies, workers: &Workers) {
        let mut next = self.ends();
        next.insert(0, 0);
        // Where each particle goes stands in the place of its cell, which is not needed any more.
        let places = &mut self.cell;
        for (order, bounds) in self.order.chunks(self.piece).zip(&self.bounds) {
            for (next, ends) in next.iter_mut().zip(bounds.windows(2)) {
                for &i in &order[ends[0] as usize..ends[1] as usize] {
                    places[i as usize] = *next as u32;
                    *next += 1;
                }
            }
        }
        let numbers = vec![
            (&from.x, &mut to.x),
            (&from.y, &mut to.y),
            (&from.vx, &mut to.vx),
            (&from.vy, &mut to.vy),
        ];
        workers.map(numbers, |(from, to)| put(to, from, &self.cell));
        put(&mut to.id, &from.id, &self.cell);
    }
}

/// `to[places[k]] = from[k]`.
fn put<T: Copy>(to: &mut [T], from: &[T], places: &[u32]) {
    for (from, &place) in from.iter().zip(places) {
        to[place as usize] = *from;
    }
}

/// `to[k] = from[source[k]]`.
pub(super) fn fetch<T: Copy>(to: &mut [T], from: &[T], source: &[u32]) {
    for (to, &i) in to.iter_mut().zip(source) {
        *to = from[i as usize];
    }
}

/// The cells of a piece of particles.
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

/// Puts the numbers of particles `first ..` in the order of their bands, and brings back where
/// each band begins.
fn order_by_band(
    cell: &[u32],
    order: &mut [u32],
    first: usize,
    band_cells: usize,
    bands: usize,
) -> Vec<u32> {
    let band_of = |cell: u32| cell as usize / band_cells;
    let mut counts = vec![0_u32; bands + 1];
    let (least, most) = cell.iter().fold((u32::MAX, 0), |(a, b), &c| (a.min(c), b.max(c)));
    let (least, most) = (band_of(least), band_of(most));
    if least == most {
        order.iter_mut().enumerate().for_each(|(i, place)| *place = (first + i) as u32);
        counts[least + 1..].fill(cell.len() as u32);
        return counts;
    }
    // After the first sort a piece belongs to few bands: one pass for each of them.
    if most - least < 4 {
        let mut len = 0;
        for band in least..=most {
            let own = (band * band_cells) as u32..((band + 1) * band_cells) as u32;
            for (i, c) in cell.iter().enumerate() {
                if own.contains(c) {
                    order[len] = (first + i) as u32;
                    len += 1;
                }
            }
            counts[band + 1] = len as u32;
        }
        counts[most + 1..].fill(len as u32);
        return counts;
    }
    cell.iter().for_each(|&c| counts[band_of(c) + 1] += 1);
    for band in 0..bands {
        counts[band + 1] += counts[band];
    }
    let mut next = counts.clone();
    for (i, &c) in cell.iter().enumerate() {
        let place = &mut next[band_of(c)];
        order[*place as usize] = (first + i) as u32;
        *place += 1;
    }
    counts
}
