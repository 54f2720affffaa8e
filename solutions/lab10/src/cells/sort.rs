//! Sorting particles by cell: a counting sort by many threads.
//!
//! Cells are cut into bands of rows. Piece by piece of the old order, particles are first put in
//! the order of their bands; then every band collects its own and counts them into its cells. A
//! band is small enough for the cache, and no two threads write to the same place. The order
//! depends on the particles alone, not on the threads.

use std::ops::Range;

use pulp::{Arch, NullaryFnOnce};

use super::grid::Grid;
use super::table::{Cells, Kind};
use crate::particles::Bodies;
use crate::threads::{LEAST, Workers, cut, pieces};

/// Most pieces, and most bands.
const MOST: usize = 256;

/// What a sort needs for itself, kept from one to the next.
#[derive(Default)]
pub struct Sorter {
    cell: Vec<u32>,
    order: Vec<u32>,
    source: Vec<u32>,
    /// Arrays of cells that are no longer needed.
    homes: Vec<u32>,
    starts: Vec<u32>,
}

/// The cells of a piece of particles.
struct Locate<'a> {
    cell: &'a mut [u32],
    bodies: &'a Bodies,
    first: usize,
    grid: Grid,
    ahead: f64,
}

impl NullaryFnOnce for Locate<'_> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        let Self { cell, bodies, first, grid, ahead } = self;
        let range = first..first + cell.len();
        let (x, y) = (&bodies.x[range.clone()], &bodies.y[range.clone()]);
        let (vx, vy) = (&bodies.vx[range.clone()], &bodies.vy[range]);
        for i in 0..cell.len() {
            let column = grid.column(x[i] + vx[i] * ahead);
            cell[i] = grid.row(y[i] + vy[i] * ahead) * grid.columns + column;
        }
    }
}

impl Sorter {
    /// Sorts `from` into `to` by the cells of `grid` where free flight takes the particles within
    /// time `ahead`: all cells are stored if `dense`, else the occupied ones. Within a cell
    /// particles keep the order they come in.
    pub fn sort(
        &mut self,
        from: &Bodies,
        to: &mut Bodies,
        grid: Grid,
        dense: bool,
        ahead: f64,
        workers: &Workers,
    ) -> Cells {
        to.resize(from.len());
        let (kind, home) = if dense {
            let mut home = std::mem::take(&mut self.homes);
            home.resize(from.len(), 0);
            let starts = self.sort_dense(from, to, &mut home, grid, ahead, workers);
            (Kind::Dense { starts }, home)
        } else {
            (sort_sparse(from, to, grid, ahead), Vec::new())
        };
        Cells { grid, kind, home }
    }

    /// Takes cells back, for their memory.
    pub fn take_back(&mut self, cells: Cells) {
        if let Kind::Dense { starts } = cells.kind {
            (self.starts, self.homes) = (starts, cells.home);
        }
    }

    fn sort_dense(
        &mut self,
        from: &Bodies,
        to: &mut Bodies,
        home: &mut [u32],
        grid: Grid,
        ahead: f64,
        workers: &Workers,
    ) -> Vec<u32> {
        let n = from.len();
        let columns = grid.columns as usize;
        let piece = pieces(n, LEAST, MOST);
        let bands = n.div_ceil(piece).min(grid.rows as usize);
        let band_rows = (grid.rows as usize).div_ceil(bands);
        let bands = (grid.rows as usize).div_ceil(band_rows);
        let band_cells = band_rows * columns;

        // 1. Every piece of the old order: the particles' cells, and their order by band.
        self.cell.resize(n, 0);
        self.order.resize(n, 0);
        self.source.resize(n, 0);
        let arch = Arch::new();
        let work =
            self.cell.chunks_mut(piece).zip(self.order.chunks_mut(piece)).enumerate().collect();
        let ends: Vec<Vec<u32>> =
            workers.map(work, |(k, (cell, order)): (usize, (&mut [u32], &mut [u32]))| {
                let first = k * piece;
                arch.dispatch(Locate { cell, bodies: from, first, grid, ahead });
                order_by_band(cell, order, first, band_cells, bands)
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

        // 3. Every band: count its particles into its cells, then fetch them in that order.
        let cells = grid.rows as usize * columns;
        let mut starts = std::mem::take(&mut self.starts);
        starts.resize(cells + 1, 0);
        let cell_ends = (0..bands).map(|band| ((band + 1) * band_cells).min(cells));
        let bounds = || band_ends.iter().copied();
        let work: Vec<_> = cut(&mut starts[1..], cell_ends)
            .into_iter()
            .zip(cut(&mut to.x, bounds()).into_iter().zip(cut(&mut to.y, bounds())))
            .zip(cut(&mut to.vx, bounds()).into_iter().zip(cut(&mut to.vy, bounds())))
            .zip(cut(&mut to.id, bounds()).into_iter().zip(cut(home, bounds())))
            .zip(cut(&mut self.source, bounds()))
            .enumerate()
            .collect();
        let (cell, order) = (&self.cell[..], &self.order[..]);
        workers.map(work, |(band, ((((ends_of, (x, y)), (vx, vy)), (id, home)), source))| {
            let mine = |(k, e): (usize, &Vec<u32>)| -> Range<usize> {
                k * piece + e[band] as usize..k * piece + e[band + 1] as usize
            };
            let ranges = || ends.iter().enumerate().map(mine).filter(|range| !range.is_empty());
            let first_cell = (band * band_cells) as u32;
            let first = band.checked_sub(1).map_or(0, |before| band_ends[before]) as u32;
            ends_of.fill(0);
            for range in ranges() {
                for &i in &order[range] {
                    ends_of[(cell[i as usize] - first_cell) as usize] += 1;
                }
            }
            let mut start = 0;
            for end in ends_of.iter_mut() {
                start += std::mem::replace(end, start);
            }
            for range in ranges() {
                for &i in &order[range] {
                    let next = &mut ends_of[(cell[i as usize] - first_cell) as usize];
                    source[*next as usize] = i;
                    *next += 1;
                }
            }
            for end in ends_of.iter_mut() {
                *end += first;
            }
            fetch(x, &from.x, source);
            fetch(y, &from.y, source);
            fetch(vx, &from.vx, source);
            fetch(vy, &from.vy, source);
            fetch(id, &from.id, source);
            fetch(home, cell, source);
        });
        starts
    }
}

/// Sorts `from` into `to` by the cells of `grid` where free flight takes the particles within time
/// `ahead`. Only occupied cells are stored.
fn sort_sparse(from: &Bodies, to: &mut Bodies, grid: Grid, ahead: f64) -> Kind {
    let key = |i: usize| {
        let column = grid.column(from.x[i] + from.vx[i] * ahead);
        u64::from(grid.row(from.y[i] + from.vy[i] * ahead)) * u64::from(grid.columns)
            + u64::from(column)
    };
    let mut order: Vec<(u64, u32)> = (0..from.len()).map(|i| (key(i), i as u32)).collect();
    order.sort_unstable();
    let (mut keys, mut starts) = (Vec::new(), Vec::new());
    for (place, &(key, i)) in order.iter().enumerate() {
        if keys.last() != Some(&key) {
            keys.push(key);
            starts.push(place as u32);
        }
        to.set(place, from.get(i as usize));
    }
    starts.push(order.len() as u32);
    Kind::Sparse { keys, starts }
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

/// `to[k] = from[source[k]]`.
fn fetch<T: Copy>(to: &mut [T], from: &[T], source: &[u32]) {
    for (to, &i) in to.iter_mut().zip(source) {
        *to = from[i as usize];
    }
}
