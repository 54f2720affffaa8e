//! The border of a rank: own particles that are ghosts elsewhere, ghosts that are here, and the
//! pairs of both.

use std::ops::Range;

use common::soft::Observer;
use mpi::Rank;
use solution10::kernels::{Pair, Places};
use solution10::{BATCH, Bodies, Contacts, Pushes};

use crate::{choose, pairs_across};

/// What was chosen when the list was made, and the places of the step.
#[derive(Default)]
pub(super) struct Border {
    /// The ranks on the other side.
    pub(super) partners: Vec<Rank>,
    /// For each partner the own particles that it needs.
    chosen: Vec<Vec<u32>>,
    /// Their places: all x, then all y.
    pub(super) sent: Vec<Vec<f64>>,
    /// The ghosts that each partner sends, in the same form.
    pub(super) received: Vec<Vec<f64>>,
    /// For each partner the pairs of a pushed particle, counted in `pushed`, and a ghost.
    pairs: Vec<Vec<Pair>>,
    /// The own particles that ghosts may push, ascending.
    pub(super) pushed: Vec<u32>,
    x: Vec<f64>,
    y: Vec<f64>,
    ax: Vec<f64>,
    ay: Vec<f64>,
    contacts: Contacts,
}

impl Border {
    /// Chooses the ghosts of all `partners`, which have these `strips`.
    pub(super) fn choose(
        &mut self,
        bodies: &Bodies,
        partners: Vec<Rank>,
        strips: impl Fn(Rank) -> Range<f64>,
        width: f64,
    ) {
        self.chosen =
            partners.iter().map(|rank| choose(&bodies.y, &strips(*rank), width)).collect();
        self.sent.resize_with(partners.len(), Vec::new);
        self.partners = partners;
        self.pushed.clear();
        self.pack(bodies);
    }

    /// How many ghosts are here.
    pub(super) fn ghosts(&self) -> usize {
        self.received.iter().map(|places| places.len() / 2).sum()
    }

    /// Lists the pairs within `reach` of own particles and the ghosts that `received` brought.
    pub(super) fn list(&mut self, received: Vec<Vec<f64>>, reach: f64) {
        self.received = received;
        let lists = self.sent.iter().zip(&self.received);
        self.pairs =
            lists.map(|(own, ghosts)| pairs_across(halves(own), halves(ghosts), reach)).collect();
        let of_partner = self.pairs.iter_mut().zip(&self.chosen);
        for (pairs, chosen) in of_partner {
            pairs.iter_mut().for_each(|[own, _]| *own = chosen[*own as usize]);
            self.pushed.extend(pairs.iter().map(|[own, _]| *own));
        }
        self.pushed.sort_unstable();
        self.pushed.dedup();
        for [own, _] in self.pairs.iter_mut().flatten() {
            *own = self.pushed.partition_point(|place| place < own) as u32;
        }
    }

    /// Looks where the own particles of the border are now.
    pub(super) fn pack(&mut self, bodies: &Bodies) {
        let fetch = |to: &mut Vec<f64>, from: &[f64], places: &[u32]| {
            to.extend(places.iter().map(|place| from[*place as usize]));
        };
        for (to, chosen) in self.sent.iter_mut().zip(&self.chosen) {
            to.clear();
            fetch(to, &bodies.x, chosen);
            fetch(to, &bodies.y, chosen);
        }
        self.x.clear();
        self.y.clear();
        fetch(&mut self.x, &bodies.x, &self.pushed);
        fetch(&mut self.y, &bodies.y, &self.pushed);
    }

    /// What the ghosts do to the own particles, with ghosts that have just arrived.
    pub(super) fn pushes(&mut self, observer: &mut impl Observer) -> Pushes<'_> {
        let Self { pairs, received, pushed, x, y, ax, ay, contacts, .. } = self;
        for sums in [&mut *ax, &mut *ay] {
            sums.clear();
            sums.resize(pushed.len(), 0.0);
        }
        for (pairs, ghosts) in pairs.iter().zip(received) {
            let ghosts = halves(ghosts);
            observer.tested(pairs.len() as u64);
            for some in pairs.chunks(BATCH) {
                if contacts.is_full() {
                    contacts.settle(ax, ay, observer);
                }
                for &[own, ghost] in some {
                    let (i, j) = (own as usize, ghost as usize);
                    contacts.offer(own, ghosts.x[j] - x[i], ghosts.y[j] - y[i]);
                }
            }
        }
        contacts.settle(ax, ay, observer);
        Pushes { places: pushed, x: ax, y: ay }
    }
}

/// Places as they are sent.
fn halves(places: &[f64]) -> Places<'_> {
    let (x, y) = places.split_at(places.len() / 2);
    Places { x, y, first: 0 }
}
