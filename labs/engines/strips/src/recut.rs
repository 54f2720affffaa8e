//! Cuts the strips again if one rank has too much work.

use common::soft::{Observer, Particle};
use common_mpi::{Wire, by_rank};
use solution6::{balanced, exchange_all};

use crate::domain::Domain;
use crate::partition::{Partition, Strips};

/// Ratio of a rank's load to the mean, above which strips are cut again.
const TOLERANCE: f64 = 1.05;

impl<O: Observer> Domain<O> {
    /// Cuts the strips again if a test is due and one rank has too much work.
    ///
    /// All ranks call this function together when ghosts are about to be chosen and each rank has
    /// its own particles only.
    pub(crate) fn keep_balance<T: Partition>(&mut self) {
        if self.rebalance == 0 || !self.counts.choices.is_multiple_of(self.rebalance) {
            return;
        }
        let load = T::load(self.engine.bodies().len(), self.engine.list().pairs());
        let most = self.greatest([load as f64])[0];
        let all = self.sum(&[load])[0] as f64;
        if most <= TOLERANCE * all / self.ranks() as f64 {
            return;
        }
        let grid = self.grid;
        let mut counts = vec![0; grid.rows()];
        self.engine.bodies().y.iter().for_each(|y| counts[grid.row(*y)] += 1);
        let loads = self.sum(&T::weigh_rows(&counts, load));
        let strips = Strips::of(&grid, &balanced(&loads, self.ranks()));
        if strips == self.strips {
            return;
        }
        let bodies = std::mem::take(self.engine.bodies_mut());
        let all = (0..bodies.len()).map(|i| bodies.get(i));
        let addressed = all.map(|p: Particle| (strips.owner(p.y), Wire::from(&p))).collect();
        self.send_anywhere(addressed);
        self.strips = strips;
        self.counts.cuts += 1;
    }

    /// Sends each particle to the rank with which it is listed, near or far.
    pub(crate) fn send_anywhere(&mut self, particles: Vec<(usize, Wire)>) {
        let lists = by_rank(particles, self.ranks());
        self.traffic.exchanged(self.rank(), &lists);
        for wire in exchange_all(&self.world, &lists) {
            self.engine.bodies_mut().push((&wire).into());
        }
    }
}
