//! Exchanges ghosts and sums forces.

use std::ops::Range;

use common::Vec2;
use common::soft::{Observer, Particle};
use common_mpi::{Ghost, Partners};
use mpi::Rank;
use mpi::traits::*;
use solution2::Gather;

use crate::threads::sum_rows;
use crate::{Blocks, Halo, Messages, Route, border_rows};

impl<O: Observer, T: Blocks + Messages> Halo<O, T> {
    /// Sums the forces of the interior rows while ghosts travel, and then the forces of the border
    /// rows.
    ///
    /// All ranks call this function together.
    pub(crate) fn sum_forces(&mut self) {
        self.accelerations.resize(self.own.particles().len(), Vec2::ZERO);
        let interior = T::interior_rows(&self.block, self.own.grid().rows());
        let outgoing = self.border_lists();
        for (_, list) in &outgoing {
            self.traffic.sent(&[0_u64]);
            self.traffic.sent(list);
        }
        let own = &self.own;
        let inner = &mut self.accelerations[own.indices(interior.clone())];
        let mut work = || sum_rows::<O>(own, interior.clone(), inner, &self.workers);
        let (arrived, seen) = match self.route {
            Route::Neighbours => self.clock.call(Partners::receivers(&outgoing), || {
                T::exchange_beside(&self.world, &outgoing, || self.clock.work(work))
            }),
            Route::AllRanks => {
                let mut lists = vec![Vec::new(); self.world.size() as usize];
                for (rank, list) in outgoing {
                    lists[rank as usize] = list;
                }
                let arrived =
                    self.clock.call(Partners::All, || T::exchange_all(&self.world, &lists));
                (vec![arrived], work())
            }
        };
        self.observer.merge(&seen);
        self.take_ghosts(&arrived);
        for rows in border_rows(&self.block, &interior) {
            self.sum_border(rows);
        }
    }

    /// Returns the ghosts for each neighbour. The rank before gets the first row, and the rank
    /// after gets the last row.
    fn border_lists(&self) -> Vec<(Rank, Vec<Ghost>)> {
        let Range { start, end } = self.block;
        let columns = 0..self.own.grid().columns();
        let rows = [start, end.saturating_sub(1)];
        let neighbours = T::neighbours(&self.cuts, self.rank()).into_iter().zip(rows);
        neighbours
            .filter_map(|(neighbour, row)| {
                let neighbour = neighbour? as Rank;
                let particles = self.own.bins(row, columns.clone());
                Some((neighbour, particles.iter().map(Ghost::from).collect()))
            })
            .collect()
    }

    /// Replaces the ghosts of the last step by the ghosts that arrived.
    fn take_ghosts(&mut self, arrived: &[Vec<Ghost>]) {
        let grid = *self.own.grid();
        let start = self.block.start;
        let all = arrived.iter().flatten().map(Particle::from);
        let (below, above): (Vec<_>, Vec<_>) = all.partition(|ghost| grid.row(ghost.y) < start);
        let [before, after] = &mut self.ghosts;
        before.refill(below);
        after.refill(above);
    }

    fn sum_border(&mut self, rows: Range<usize>) {
        let grid = *self.own.grid();
        let mut gather = Gather::default();
        let range = self.own.indices(rows);
        let own = &self.own;
        let [before, after] = &self.ghosts;
        let particles = &own.particles()[range.clone()];
        for (particle, a) in particles.iter().zip(&mut self.accelerations[range]) {
            let columns = grid.near(grid.column(particle.x));
            let around = grid.near(grid.row(particle.y)).map(|row| {
                let bins = match row {
                    row if row < self.block.start => before,
                    row if row < self.block.end => own,
                    _ => after,
                };
                bins.bins(row, columns.clone())
            });
            *a = gather.acceleration(particle, around, &mut self.observer);
        }
    }
}
