//! Sorting particles by cell: a counting sort by many threads.
//!
//! Cells are cut into bands of rows. Piece by piece of the old order, particles are first put in
//! the order of their bands; then every band collects its own and counts them into its cells. A
//! band is small enough for the cache, and no two threads write to the same place. The order
//! depends on the particles alone, not on the threads.

use super::bands::{Bands, fetch};
use super::grid::Grid;
use super::table::{Cells, Kind};
use crate::particles::{Bodies, make_room};
use crate::threads::{Workers, cut};

/// What a sort needs for itself, kept from one to the next.
#[derive(Default)]
pub struct Sorter {
    bands: Bands,
    /// Arrays of cells that are no longer needed.
    homes: Vec<u32>,
    starts: Vec<u32>,
}

impl Sorter {
    /// Sorts `bodies` by the cells of `grid`: all cells are stored if `dense`, else the occupied ones.
    /// Within a cell particles keep the order they come in. Afterwards `spare` has them unsorted: in an order that would be sorted
    /// alike.
    pub fn sort(
        &mut self,
        bodies: &mut Bodies,
        spare: &mut Bodies,
        grid: Grid,
        dense: bool,
        workers: &Workers,
    ) -> Cells {
        spare.resize(bodies.len());
        let (kind, home) = if dense {
            let mut home = std::mem::take(&mut self.homes);
            make_room(&mut home, bodies.len());
            let starts = self.sort_dense(bodies, spare, &mut home, grid, workers);
            (Kind::Dense { starts }, home)
        } else {
            (sort_sparse(bodies, spare, grid), Vec::new())
        };
        std::mem::swap(bodies, spare);
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
        bodies: &mut Bodies,
        spare: &mut Bodies,
        home: &mut [u32],
        grid: Grid,
        workers: &Workers,
    ) -> Vec<u32> {
        self.bands.find(bodies, grid, workers);
        if self.bands.are_scattered() {
            // Twice through memory in order is faster than once to each particle.
            self.bands.spread(bodies, spare, workers);
            std::mem::swap(bodies, spare);
            self.bands.find(bodies, grid, workers);
        }

        // Every band: count its particles into its cells, then fetch them in that order.
        let (from, to, bands) = (&*bodies, spare, &self.bands);
        let cells = grid.rows as usize * grid.columns as usize;
        let mut starts = std::mem::take(&mut self.starts);
        make_room(&mut starts, cells + 1);
        let ends = bands.ends();
        let cell_ends = (1..=ends.len()).map(|band| (band * bands.cells).min(cells));
        let bounds = || ends.iter().copied();
        let work: Vec<_> = cut(&mut starts[1..], cell_ends)
            .into_iter()
            .zip(cut(&mut to.x, bounds()).into_iter().zip(cut(&mut to.y, bounds())))
            .zip(cut(&mut to.vx, bounds()).into_iter().zip(cut(&mut to.vy, bounds())))
            .zip(cut(&mut to.id, bounds()).into_iter().zip(cut(home, bounds())))
            .enumerate()
            .collect();
        workers.map(work, |(band, (((ends_of, (x, y)), (vx, vy)), (id, home)))| {
            let first_cell = (band * bands.cells) as u32;
            let first = band.checked_sub(1).map_or(0, |before| ends[before]) as u32;
            let cell_of = |i: u32| (bands.cell[i as usize] - first_cell) as usize;
            ends_of.fill(0);
            for run in bands.runs(band) {
                run.iter().for_each(|&i| ends_of[cell_of(i)] += 1);
            }
            let mut source = vec![0; home.len()];
            let mut start = 0;
            for end in ends_of.iter_mut() {
                start += std::mem::replace(end, start);
            }
            for run in bands.runs(band) {
                for &i in run {
                    let next = &mut ends_of[cell_of(i)];
                    source[*next as usize] = i;
                    *next += 1;
                }
            }
            for end in ends_of.iter_mut() {
                *end += first;
            }
            fetch(x, &from.x, &source);
            fetch(y, &from.y, &source);
            fetch(vx, &from.vx, &source);
            fetch(vy, &from.vy, &source);
            fetch(id, &from.id, &source);
            fetch(home, &bands.cell, &source);
        });
        starts
    }
}

/// Sorts `from` into `to` by the cells of `grid`. Only occupied cells are stored.
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
        to.set(place, from.get(i as usize));
    }
    starts.push(order.len() as u32);
    Kind::Sparse { keys, starts }
}
