//! The accelerations of all particles at given places.

use common::Vec2;
use common::soft::{CUTOFF, NoStatistics};
use solution10::{BATCH, Bodies, Contacts, Extent, Grid, Sorter, Workers};

/// Particles in a piece of work, roughly.
const PIECE: usize = 1024;

/// Computes accelerations by cells, with what it keeps from one time to the next.
pub(super) struct Field {
    workers: Workers,
    sorter: Sorter,
    sorted: Bodies,
    spare: Bodies,
}

impl Field {
    /// A field for `threads` threads.
    pub(super) fn new(threads: usize) -> Self {
        let (sorted, spare) = (Bodies::default(), Bodies::default());
        Self { workers: Workers::new(threads), sorter: Sorter::default(), sorted, spare }
    }

    /// Writes the accelerations of particles at places `at` into `a`, which is as long.
    pub(super) fn accelerations(&mut self, at: &[Vec2], a: &mut [Vec2]) {
        let Self { workers, sorter, sorted, spare } = self;
        sorted.resize(at.len());
        for (i, at) in at.iter().enumerate() {
            (sorted.x[i], sorted.y[i], sorted.id[i]) = (at.x, at.y, i as u32);
        }
        let grid = Grid::new(&Extent::of(sorted), CUTOFF);
        let dense = grid.cells() <= 16 * at.len() as u64 + 64;
        let cells = sorter.sort(sorted, spare, grid, dense, workers);
        let results = workers.map(cells.pieces(PIECE), |piece| {
            let particles = cells.particles(&piece);
            let (mut ax, mut ay) = (vec![0.0; particles.len()], vec![0.0; particles.len()]);
            let mut contacts = Contacts::default();
            for k in piece.filter(|&k| !cells.own(k).is_empty()) {
                let rows = cells.around(k);
                for i in cells.own(k) {
                    for (row, from) in rows
                        .iter()
                        .flat_map(|row| row.clone().step_by(BATCH).map(move |from| (row, from)))
                    {
                        if contacts.is_full() {
                            contacts.settle(&mut ax, &mut ay, &mut NoStatistics);
                        }
                        for j in from..(from + BATCH).min(row.end) {
                            let (dx, dy) = (sorted.x[j] - sorted.x[i], sorted.y[j] - sorted.y[i]);
                            contacts.offer((i - particles.start) as u32, dx, dy);
                        }
                    }
                }
            }
            contacts.settle(&mut ax, &mut ay, &mut NoStatistics);
            (particles, ax, ay)
        });
        for (particles, ax, ay) in results {
            for ((i, ax), ay) in particles.zip(ax).zip(ay) {
                a[sorted.id[i] as usize] = Vec2::new(ax, ay);
            }
        }
    }
}
