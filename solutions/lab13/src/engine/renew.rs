//! What happens when lists are made anew: particles change their ranks, strips are cut, ghosts are
//! chosen.

use common::soft::{Observer, Particle};
use common_mpi::Wire;
use mpi::Rank;
use mpi::collective::SystemOperation;
use mpi::traits::*;
use solution6::{balanced, exchange_all, exchange_beside};

use super::Distributed;
use crate::{Scenery, Strips, best_steps, ghost_width, load, weigh_rows};

/// The most that a rank's load may be above the mean before the strips are cut anew.
const TOLERANCE: f64 = 1.05;
/// No list is expected to last longer.
const LONGEST: f64 = 200.0;
/// Ghosts are chosen for particles that become so many times as fast.
const FASTER: f64 = 1.1;

impl<O: Observer> Distributed<O> {
    /// Makes all lists anew. All ranks call it together.
    pub(super) fn renew(&mut self) {
        self.migrate();
        if self.rebalance > 0 && self.counts.lists.is_multiple_of(self.rebalance) {
            self.keep_balance();
        }
        self.engine.renew();
        self.choose_width();
        self.choose_ghosts();
        self.moved = 0.0;
        self.counts.lists += 1;
    }

    /// Sends particles that left the strip to their new owners.
    ///
    /// No particle has gone further than ghosts are wide, unless it was pushed in the last step as
    /// none was before. So particles go to partners, and only if there are any that go further do
    /// all ranks exchange.
    fn migrate(&mut self) {
        let own = self.strips.strip(self.rank());
        let bodies = self.engine.bodies_mut();
        let left: Vec<usize> = (0..bodies.len()).filter(|&i| !own.contains(&bodies.y[i])).collect();
        let mut near = vec![Vec::new(); self.border.partners.len()];
        let mut far = Vec::new();
        // From the last to the first, so that a particle that fills a gap has been handled.
        for i in left.into_iter().rev() {
            let wire = Wire::from(&bodies.swap_remove(i));
            let owner = self.strips.owner(wire.y);
            match self.border.partners.binary_search(&(owner as Rank)) {
                Ok(k) => near[k].push(wire),
                Err(_) => far.push((owner, wire)),
            }
        }
        let outgoing: Vec<_> = self.border.partners.iter().copied().zip(near).collect();
        for wire in self.exchange(&outgoing).concat() {
            self.engine.bodies_mut().push((&wire).into());
        }
        if self.greatest([far.len() as f64])[0] > 0.0 {
            self.send_anywhere(far);
        }
    }

    /// Sends particles to the ranks they are listed with, near or far.
    fn send_anywhere(&mut self, particles: Vec<(usize, Wire)>) {
        let mut lists = vec![Vec::new(); self.ranks()];
        for (rank, wire) in particles {
            lists[rank].push(wire);
        }
        let rank = self.rank();
        for (_, list) in lists.iter().enumerate().filter(|(other, _)| *other != rank) {
            self.traffic.sent(&[0_i32]);
            if !list.is_empty() {
                self.traffic.sent(list);
            }
        }
        for wire in exchange_all(&self.world, &lists) {
            self.engine.bodies_mut().push((&wire).into());
        }
    }

    /// Cuts the strips anew if one rank has too much work.
    fn keep_balance(&mut self) {
        let load = load(self.engine.bodies().len(), self.engine.list().pairs());
        let most = self.greatest([load as f64])[0];
        let all = self.sum(&[load])[0] as f64;
        if most <= TOLERANCE * all / self.ranks() as f64 {
            return;
        }
        let (grid, bodies) = (self.grid, self.engine.bodies());
        let mut counts = vec![0; grid.rows()];
        bodies.y.iter().for_each(|y| counts[grid.row(*y)] += 1);
        let loads = self.sum(&weigh_rows(&counts, load));
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

    /// All ranks choose the same width of ghosts, by what the fastest, the densest and the one with
    /// the shortest list of them expects.
    fn choose_width(&mut self) {
        let n = self.engine.bodies().len();
        let (list, limits) = (self.engine.list(), self.engine.limits());
        let [mut wear, mut density] = [0.0; 2];
        if n > 0 {
            let steps = (0.5 * list.budget.skin / limits.displacement()).floor() + 1.0;
            (wear, density) = (1.0 / steps, list.density(n));
        }
        let [fastest, wear, density] = self.greatest([self.fastest, wear, density]);
        let most = (1.0 / wear).clamp(1.0, LONGEST).round() as u32;
        let height = self.grid.size() / self.ranks() as f64;
        let fastest = FASTER * fastest;
        let steps = best_steps(Scenery { fastest, density, height, most });
        self.width = ghost_width(fastest, steps);
        self.counts.widths += self.width;
    }

    /// Chooses the ghosts, and lists the pairs across the border.
    fn choose_ghosts(&mut self) {
        // Places are rounded; a pair must not be missed for that.
        let reach = self.width * (1.0 + 1e-9) + 1e-15 * self.grid.size();
        let strips = &self.strips;
        let partners = strips.partners(self.rank(), reach);
        let strip = |rank: Rank| strips.strip(rank as usize);
        self.border.choose(self.engine.bodies(), partners, strip, reach);
        let partners = self.border.partners.iter().copied();
        let outgoing: Vec<_> = partners.zip(self.border.sent.iter().cloned()).collect();
        let received = self.exchange(&outgoing);
        self.border.list(received, reach);
        self.counts.ghosts += self.border.ghosts() as u64;
    }

    /// Lists to partners and lists from them, lengths and all.
    fn exchange<T>(&mut self, outgoing: &[(Rank, Vec<T>)]) -> Vec<Vec<T>>
    where
        T: Equivalence + Default + Clone,
    {
        for (_, list) in outgoing {
            self.traffic.sent(&[0_u64]);
            self.traffic.sent(list);
        }
        exchange_beside(&self.world, outgoing, || ()).0
    }

    /// The greatest of each number over all ranks.
    fn greatest<const N: usize>(&mut self, own: [f64; N]) -> [f64; N] {
        let mut all = own;
        self.count_reduction(&own);
        self.world.all_reduce_into(&own[..], &mut all[..], SystemOperation::max());
        all
    }

    /// The sum of each number over all ranks.
    fn sum(&mut self, own: &[u64]) -> Vec<u64> {
        let mut all = vec![0; own.len()];
        self.count_reduction(own);
        self.world.all_reduce_into(own, &mut all[..], SystemOperation::sum());
        all
    }
}
