//! Moves particles to other ranks, and divides the rows again if one rank has too many particles.

use common::soft::{Observer, Particle};
use common_mpi::{Partners, Wire, by_rank};
use mpi::Rank;
use mpi::collective::SystemOperation;
use mpi::traits::*;

use crate::threads::move_all;
use crate::{Blocks, Cuts, Halo, Messages, Route};

/// Ratio of the fullest rank's particles to the mean, above which rows are divided again.
const TOLERANCE: f64 = 1.05;

impl<O: Observer, T: Blocks + Messages> Halo<O, T> {
    /// Moves the rank's particles, and removes and returns the particles that left the block.
    pub(crate) fn move_particles(&mut self) -> Vec<Wire> {
        let grid = *self.own.grid();
        let particles = self.own.particles_mut();
        let indices = move_all(particles, &self.accelerations, &grid, &self.block, &self.workers);
        // A later particle takes the place of a removed particle. The loop runs backwards, so that
        // the later particle has already been handled.
        indices.iter().rev().map(|&index| Wire::from(&self.own.take(index))).collect()
    }

    /// Sends `leavers` to their new owners and takes in the particles that arrive.
    ///
    /// With [`Route::Neighbours`], the rank sends messages to the neighbours. Some particles may go
    /// further than that. All ranks add up the number of such particles, and exchange them only if
    /// the number is not zero.
    pub(crate) fn migrate(&mut self, leavers: Vec<Wire>) {
        let grid = *self.own.grid();
        let neighbours = T::neighbours(&self.cuts, self.rank());
        let (near, far) = match self.route {
            Route::Neighbours => {
                let sorted = T::sort_leavers(&grid, &self.cuts, neighbours, &leavers);
                (sorted.near, sorted.far)
            }
            Route::AllRanks => {
                let addressed =
                    leavers.iter().map(|wire| (self.cuts.owner(grid.row(wire.y)), *wire));
                (<_>::default(), addressed.collect())
            }
        };
        let mut any_far = true;
        if self.route == Route::Neighbours {
            let outgoing: Vec<_> = neighbours
                .into_iter()
                .zip(near)
                .filter_map(|(neighbour, list)| Some((neighbour? as Rank, list)))
                .collect();
            for (_, list) in &outgoing {
                self.traffic.sent(&[0_u64]);
                self.traffic.sent(list);
            }
            let (arrived, ()) = self.clock.call(Partners::receivers(&outgoing), || {
                T::exchange_beside(&self.world, &outgoing, || ())
            });
            arrived.iter().flatten().for_each(|wire| self.own.put(wire.into()));
            let own_far = far.len() as u64;
            let mut all_far = 0_u64;
            self.clock.call(Partners::All, || {
                self.world.all_reduce_into(&own_far, &mut all_far, SystemOperation::sum());
            });
            if self.ranks() > 1 {
                self.traffic.sent(&[0_u64]);
            }
            any_far = all_far > 0;
        }
        if any_far {
            for wire in self.send_anywhere(far) {
                self.own.put((&wire).into());
            }
        }
        self.own.sort();
    }

    /// Sends each particle to the rank with which it is listed, near or far.
    fn send_anywhere(&mut self, particles: Vec<(usize, Wire)>) -> Vec<Wire> {
        let lists = by_rank(particles, self.ranks());
        self.traffic.exchanged(self.rank(), &lists);
        self.clock.call(Partners::All, || T::exchange_all(&self.world, &lists))
    }

    /// Divides the rows again if one rank has too many particles.
    pub(crate) fn keep_balance(&mut self) {
        let most = self.clock.call(Partners::All, || self.fullest());
        if most as f64 <= TOLERANCE * self.n as f64 / self.ranks() as f64 {
            return;
        }
        let grid = *self.own.grid();
        let mut counts = vec![0_u64; grid.rows()];
        for row in self.block.clone() {
            counts[row] = self.own.indices(row..row + 1).len() as u64;
        }
        let mut all = vec![0_u64; grid.rows()];
        self.clock.call(Partners::All, || {
            self.world.all_reduce_into(&counts[..], &mut all[..], SystemOperation::sum());
        });
        let cuts = T::balanced(&all, self.ranks());
        if cuts == self.cuts {
            return;
        }
        self.cut_again(cuts);
        self.recuts += 1;
    }

    /// Sends each particle to the rank that has its row according to `cuts`, the new division.
    pub(crate) fn cut_again(&mut self, cuts: Cuts) {
        let grid = *self.own.grid();
        let own = self.own.particles().iter();
        let addressed = own.map(|p| (cuts.owner(grid.row(p.y)), Wire::from(p))).collect();
        let arrived = self.send_anywhere(addressed);
        self.settle(grid, cuts, arrived.iter().map(Particle::from).collect());
    }

    /// Returns the number of particles of the fullest rank. All ranks call this function together.
    pub(crate) fn fullest(&self) -> u64 {
        let own = self.own.particles().len() as u64;
        let mut most = 0_u64;
        self.world.all_reduce_into(&own, &mut most, SystemOperation::max());
        most
    }
}
