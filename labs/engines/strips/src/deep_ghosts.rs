//! The exchange before an epoch: particles are sent to all ranks that need them, once for all
//! steps.

use std::ops::{Range, RangeInclusive};

use common::soft::Particle;
use common_mpi::Wire;
use mpi::Rank;
use mpi::request;
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;

use crate::deep::Deep;
use crate::deep_halo::DeepHalo;

impl<T: DeepHalo> Deep<T> {
    /// Returns a function that tests whether the particle at an index of the engine is a ghost.
    ///
    /// Deep inside the strip there are no ghosts, so most particles need no search.
    pub(crate) fn is_ghost(&self) -> impl Fn(&usize) -> bool {
        let bodies = self.domain.engine.bodies();
        let inside = widened(self.domain.strips.strip(self.domain.rank()), -self.gone);
        move |&index| {
            !inside.contains(&bodies.y[index])
                && self.ghosts.binary_search(&bodies.id[index]).is_ok()
        }
    }

    /// Removes the ghosts of the last epoch.
    pub(crate) fn drop_ghosts(&mut self) {
        let n = self.domain.engine.bodies().len();
        let ghosts: Vec<usize> = (0..n).filter(self.is_ghost()).collect();
        // The last particle takes the place of a removed ghost. The loop runs backwards, so that
        // the last particle is not a ghost.
        for index in ghosts.into_iter().rev() {
            self.domain.engine.bodies_mut().swap_remove(index);
        }
    }

    /// Sends each partner the particles that it needs. Removes the particles that this rank no
    /// longer needs.
    ///
    /// A partner needs two kinds of particles: the particles that are now in its strip become its
    /// own, and the particles within `width` of the strip become its ghosts. One message to each
    /// partner is enough, because the rank that had a particle sends the particle to every rank
    /// that needs it. The particle may have left its strip by as much as `gone`, so ranks within
    /// `width` + `gone` are partners.
    pub(crate) fn exchange(&mut self, width: f64) {
        let rank = self.domain.rank();
        let reach = self.domain.reach(width);
        let strips = &self.domain.strips;
        let partners = T::partners(strips, rank, reach + self.gone);
        let own = strips.strip(rank);
        let strips_of = partners.iter().map(|rank| strips.strip(*rank as usize));
        let needs: Vec<_> = strips_of.map(|strip| widened(strip, reach)).collect();
        let alone = widened(own.clone(), -reach);
        let keeps = widened(own.clone(), reach);
        let mut outgoing = vec![Vec::new(); partners.len()];
        self.ghosts.clear();
        let bodies = self.domain.engine.bodies_mut();
        // A later particle takes the place of a removed particle. The loop runs backwards, so that
        // the later particle has already been handled.
        for index in (0..bodies.len()).rev() {
            let y = bodies.y[index];
            if alone.contains(&y) {
                continue;
            }
            for (needs, list) in needs.iter().zip(&mut outgoing) {
                if needs.contains(&y) {
                    list.push(Wire::from(&bodies.get(index)));
                }
            }
            if !keeps.contains(&y) {
                bodies.swap_remove(index);
            } else if !own.contains(&y) {
                self.ghosts.push(bodies.id[index]);
            }
        }
        outgoing.iter().for_each(|list| self.domain.traffic.sent(list));
        for wire in exchange_whole(&self.domain.world, &partners, &outgoing) {
            let particle = Particle::from(&wire);
            if !own.contains(&particle.y) {
                self.ghosts.push(particle.id);
            }
            bodies.push(particle);
        }
        self.ghosts.sort_unstable();
        self.domain.count_choice(width, self.ghosts.len());
    }
}

/// Returns a strip that is wider by `width` at both ends, or narrower if `width` is negative.
fn widened(strip: Range<f64>, width: f64) -> RangeInclusive<f64> {
    strip.start - width..=strip.end + width
}

/// Sends `outgoing[k]` to rank `partners[k]`, and returns the partners' items in the order of
/// partners.
///
/// No rank knows the length of a message that arrives. The receiver probes the message before it
/// makes room, so no length has to be sent first.
fn exchange_whole(
    world: &SimpleCommunicator,
    partners: &[Rank],
    outgoing: &[Vec<Wire>],
) -> Vec<Wire> {
    request::scope(|scope| {
        let mut sends = Vec::new();
        for (rank, list) in partners.iter().zip(outgoing) {
            sends.push(world.process_at_rank(*rank).immediate_send(scope, &list[..]));
        }
        let incoming =
            partners.iter().flat_map(|rank| world.process_at_rank(*rank).receive_vec().0).collect();
        sends.into_iter().for_each(|send| send.wait_without_status());
        incoming
    })
}
