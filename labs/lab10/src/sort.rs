//! Sorting particles by cell: a counting sort by many hands.
//!
//! Cells are cut into bands of rows. Piece by piece of the old order, particles are first put in
//! the order of their bands; then every band collects its own and counts them into its cells. A
//! band is small enough for the cache, and nobody writes where somebody else does. The order
//! depends on the particles alone, whoever sorts.

use std::ops::Range;

use crate::workers::{cut, pieces};
use crate::{Bodies, Cells, Grid, Kind, Workers};

/// Particles in a piece of work, roughly.
const PIECE: usize = 4096;
/// Most pieces, and most bands.
const MOST: usize = 256;

/// What a sort needs for itself, kept from one to the next.
#[derive(Default)]
pub struct Sorter {
    cell: Vec<u32>,
    order: Vec<u32>,
}

impl Sorter {
    /// Sorts `from` into `to` by the cells of `grid`: all cells if `dense`, else the occupied
    /// ones. Within a cell particles keep the order they come in.
    pub fn sort(
        &mut self,
        from: &Bodies,
        to: &mut Bodies,
        grid: Grid,
        dense: bool,
        workers: &Workers,
    ) -> Cells {
        to.resize(from.len());
        let kind = if dense {
            Kind::Dense { starts: self.sort_dense(from, to, grid, workers) }
        } else {
            sort_sparse(from, to, grid)
        };
        Cells { grid, kind }
    }

    fn sort_dense(
        &mut self,
        from: &Bodies,
        to: &mut Bodies,
        grid: Grid,
        workers: &Workers,
    ) -> Vec<u32> {
        let n = from.len();
        let columns = grid.columns as usize;
        let piece = pieces(n, PIECE, MOST);
        let bands = n.div_ceil(piece).min(grid.rows as usize);
        let band_rows = (grid.rows as usize).div_ceil(bands);
        let bands = (grid.rows as usize).div_ceil(band_rows);
        let band_of: Vec<u16> =
            (0..grid.rows as usize).map(|row| (row / band_rows) as u16).collect();

        // 1. Every piece of the old order: the particles' cells, and their order by band.
        self.cell.resize(n, 0);
        self.order.resize(n, 0);
        let work =
            self.cell.chunks_mut(piece).zip(self.order.chunks_mut(piece)).enumerate().collect();
        let ends: Vec<Vec<u32>> =
            workers.map(work, |(k, (cell, order)): (usize, (&mut [u32], &mut [u32]))| {
                let first = k * piece;
                let mut counts = vec![0_u32; bands + 1];
                let (x, y) = (&from.x[first..][..cell.len()], &from.y[first..][..cell.len()]);
                let mut last_band = usize::MAX;
                let mut mixed = false;
                for i in 0..cell.len() {
                    let row = grid.row(y[i]);
                    cell[i] = row * grid.columns + grid.column(x[i]);
                    let band = usize::from(band_of[row as usize]);
                    mixed |= band != last_band && last_band != usize::MAX;
                    last_band = band;
                    counts[band + 1] += 1;
                }
                for band in 0..bands {
                    counts[band + 1] += counts[band];
                }
                if mixed {
                    let mut next = counts.clone();
                    for (i, &c) in cell.iter().enumerate() {
                        let place = &mut next[usize::from(band_of[c as usize / columns])];
                        order[*place as usize] = (first + i) as u32;
                        *place += 1;
                    }
                } else {
                    for (i, place) in order.iter_mut().enumerate() {
                        *place = (first + i) as u32;
                    }
                }
                counts
            });

        // 2. Where each band begins in the new order.
        let size_of =
            |band: usize| ends.iter().map(|e| (e[band + 1] - e[band]) as usize).sum::<usize>();
        let band_ends: Vec<usize> = (0..bands)
            .scan(0, |end, band| {
                *end += size_of(band);
                Some(*end)
            })
            .collect();

        // 3. Every band: count its particles into its cells, then place them.
        let cells = grid.rows as usize * columns;
        let mut starts = vec![0_u32; cells + 1];
        let band_cells = (0..bands).map(|band| ((band + 1) * band_rows * columns).min(cells));
        let work: Vec<_> = cut(&mut starts[1..], band_cells)
            .into_iter()
            .zip(cut(&mut to.x, band_ends.iter().copied()))
            .zip(cut(&mut to.y, band_ends.iter().copied()))
            .zip(cut(&mut to.vx, band_ends.iter().copied()))
            .zip(cut(&mut to.vy, band_ends.iter().copied()))
            .zip(cut(&mut to.id, band_ends.iter().copied()))
            .enumerate()
            .collect();
        let (cell, order) = (&self.cell[..], &self.order[..]);
        workers.map(work, |(band, (((((ends_of, x), y), vx), vy), id))| {
            let first_cell = band * band_rows * columns;
            let first = band.checked_sub(1).map_or(0, |before| band_ends[before]);
            let mine = |(k, e): (usize, &Vec<u32>)| -> Range<usize> {
                k * piece + e[band] as usize..k * piece + e[band + 1] as usize
            };
            for range in ends.iter().enumerate().map(mine) {
                for &i in &order[range] {
                    ends_of[cell[i as usize] as usize - first_cell] += 1;
                }
            }
            let mut start = 0;
            for end in ends_of.iter_mut() {
                start += std::mem::replace(end, start);
            }
            for range in ends.iter().enumerate().map(mine) {
                for &i in &order[range] {
                    let i = i as usize;
                    let next = &mut ends_of[cell[i] as usize - first_cell];
                    let place = *next as usize;
                    *next += 1;
                    x[place] = from.x[i];
                    y[place] = from.y[i];
                    vx[place] = from.vx[i];
                    vy[place] = from.vy[i];
                    id[place] = from.id[i];
                }
            }
            for end in ends_of.iter_mut() {
                *end += first as u32;
            }
        });
        starts
    }
}

fn sort_sparse(from: &Bodies, to: &mut Bodies, grid: Grid) -> Kind {
    let key = |i: usize| {
        u64::from(grid.row(from.y[i])) * u64::from(grid.columns) + u64::from(grid.column(from.x[i]))
    };
    let mut order: Vec<(u64, u32)> = (0..from.len()).map(|i| (key(i), i as u32)).collect();
    order.sort_unstable();
    let (mut keys, mut starts) = (Vec::new(), Vec::new());
    for (place, &(key, i)) in order.iter().enumerate() {
        if keys.last() != Some(&key) {
            keys.push(key);
            starts.push(place as u32);
        }
        let i = i as usize;
        to.x[place] = from.x[i];
        to.y[place] = from.y[i];
        to.vx[place] = from.vx[i];
        to.vy[place] = from.vy[i];
        to.id[place] = from.id[i];
    }
    starts.push(order.len() as u32);
    Kind::Sparse { keys, starts }
}
