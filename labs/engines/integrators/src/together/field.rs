//! The accelerations of all particles at given positions.

use std::ops::Range;

use common::Vec2;
use common::soft::CUTOFF;
use neighbour_list::kernels::{EIGHT, Kernel, Signs, dispatch};
use neighbour_list::{Bodies, Cells, Contacts, Extent, Grid, Sorter, Workers, collect};

/// Approximate number of particles in a piece of work.
const PIECE: usize = 1024;

/// A computation of accelerations, cell by cell, that keeps its memory from one call to the next.
pub(super) struct Field {
    workers: Workers,
    sorter: Sorter,
    sorted: Bodies,
}

impl Field {
    /// Makes a field for `threads` threads.
    pub(super) fn new(threads: usize) -> Self {
        Self {
            workers: Workers::if_possible(threads),
            sorter: Sorter::default(),
            sorted: Bodies::default(),
        }
    }

    /// Writes the accelerations of particles at positions `at` to `a`. Both slices have the same
    /// length.
    pub(super) fn accelerations(&mut self, at: &[Vec2], a: &mut [Vec2]) {
        let Self { workers, sorter, sorted } = self;
        sorted.resize(at.len());
        for (i, at) in at.iter().enumerate() {
            sorted.x[i] = at.x;
            sorted.y[i] = at.y;
            sorted.id[i] = i as u32;
        }
        let grid = Grid::new(&Extent::of(sorted), CUTOFF);
        let cells = sorter.sort(sorted, grid, workers);
        let results = workers.map(cells.pieces(PIECE), |piece| {
            dispatch(Gather { bodies: sorted, cells: &cells, piece })
        });
        for (particles, ax, ay) in results {
            for ((i, ax), ay) in particles.zip(ax).zip(ay) {
                a[sorted.id[i] as usize] = Vec2::new(ax, ay);
            }
        }
    }
}

/// A vector kernel that computes the accelerations of the particles in a piece of the cells.
struct Gather<'a> {
    bodies: &'a Bodies,
    cells: &'a Cells,
    piece: Range<usize>,
}

impl Kernel for Gather<'_> {
    type Output = (Range<usize>, Vec<f64>, Vec<f64>);

    #[inline(always)]
    fn run(self, signs: impl Signs) -> Self::Output {
        let Self { bodies, cells, piece } = self;
        let particles = cells.particles(&piece);
        let positions = bodies.positions();
        let mut pairs = Vec::new();
        let mut len = 0;
        for k in piece.filter(|&k| !cells.own(k).is_empty()) {
            let rows = cells.around(k);
            for i in cells.own(k) {
                for row in rows.iter().filter(|row| !row.is_empty()) {
                    pairs.resize(pairs.len().max(len + row.len() + EIGHT), [0; 2]);
                    len = collect(&mut pairs, len, positions, i, row.clone(), CUTOFF, signs);
                }
            }
        }
        let mut ax = vec![0.0; particles.len()];
        let mut ay = vec![0.0; particles.len()];
        Contacts::default().for_each(&pairs[..len], positions, |[i, _], a, _| {
            let i = i as usize - particles.start;
            ax[i] += a[0];
            ay[i] += a[1];
        });
        (particles, ax, ay)
    }
}
