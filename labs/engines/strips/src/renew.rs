//! Renews lists and ghosts: particles change ranks, strips are cut again, ghosts are chosen.

use common::soft::Observer;
use common_mpi::Wire;
use mpi::Rank;
use mpi::traits::*;
use solution6::exchange_beside;

use crate::distributed::Distributed;
use crate::domain::lists_last;
use crate::sent_halo::{Halo, Scenery};

/// Speed that the choice of ghosts allows for, as a multiple of the speed of the fastest particle
/// at that moment.
const FASTER: f64 = 1.1;

impl<O: Observer, T: Halo> Distributed<O, T> {
    /// Rebuilds all lists. All ranks call this function together.
    pub(crate) fn renew(&mut self) {
        self.migrate();
        self.domain.keep_balance::<T>();
        self.domain.engine.rebuild();
        self.choose_width();
        self.choose_ghosts();
        self.moved = 0.0;
    }

    /// Sends particles that have left the strip to their new owners.
    ///
    /// A particle has gone no further than ghosts are wide, unless it became faster in the last
    /// step than any particle was before. So a particle nearly always goes to a partner. All ranks
    /// exchange particles only if some particle moves further.
    fn migrate(&mut self) {
        let own = self.domain.strips.strip(self.domain.rank());
        let bodies = self.domain.engine.bodies_mut();
        let left: Vec<usize> = (0..bodies.len()).filter(|&i| !own.contains(&bodies.y[i])).collect();
        let mut near = vec![Vec::new(); self.border.partners.len()];
        let mut far = Vec::new();
        // The last particle takes the place of a removed particle. The loop runs backwards, so that
        // the last particle has already been handled.
        for i in left.into_iter().rev() {
            let wire = Wire::from(&bodies.swap_remove(i));
            let owner = self.domain.strips.owner(wire.y);
            match self.border.partners.binary_search(&(owner as Rank)) {
                Ok(k) => near[k].push(wire),
                Err(_) => far.push((owner, wire)),
            }
        }
        let outgoing: Vec<_> = self.border.partners.iter().copied().zip(near).collect();
        for wire in self.exchange(&outgoing).concat() {
            self.domain.engine.bodies_mut().push((&wire).into());
        }
        if self.domain.greatest([far.len() as f64])[0] > 0.0 {
            self.domain.send_anywhere(far);
        }
    }

    /// Chooses the width of ghosts, the same on all ranks.
    ///
    /// The width follows from the greatest speed, the greatest density and the shortest life of a
    /// list among all ranks.
    fn choose_width(&mut self) {
        let n = self.domain.engine.bodies().len();
        let density = if n > 0 { self.domain.engine.list().density(n) } else { 0.0 };
        let own = [self.fastest, self.domain.wear(), density];
        let [fastest, wear, density] = self.domain.greatest(own);
        let most = lists_last(wear);
        let fastest = FASTER * fastest;
        let scenery = Scenery { fastest, density, height: self.domain.height(), most };
        self.width = T::ghost_width(fastest, T::best_steps(scenery));
    }

    /// Chooses the ghosts, and lists the pairs across the border.
    fn choose_ghosts(&mut self) {
        let reach = self.domain.reach(self.width);
        let strips = &self.domain.strips;
        let partners = T::partners(strips, self.domain.rank(), reach);
        self.border.choose::<T>(self.domain.engine.bodies(), partners, strips, reach);
        let partners = self.border.partners.iter().copied();
        let outgoing: Vec<_> = partners.zip(self.border.sent.iter().cloned()).collect();
        let received = self.exchange(&outgoing);
        self.border.list::<T>(received, reach);
        self.domain.count_choice(self.width, self.border.ghosts());
    }

    /// Sends a list to each partner and returns the lists of the partners. The lengths are sent
    /// first.
    fn exchange<W>(&mut self, outgoing: &[(Rank, Vec<W>)]) -> Vec<Vec<W>>
    where
        W: Equivalence + Default + Clone,
    {
        for (_, list) in outgoing {
            self.domain.traffic.sent(&[0_u64]);
            self.domain.traffic.sent(list);
        }
        exchange_beside(&self.domain.world, outgoing, || ()).0
    }
}
