//! The border of a rank: own particles that are ghosts elsewhere, ghosts that are here, and the
//! pairs of both.

use std::ops::Range;

use common::soft::Observer;
use mpi::Rank;
use neighbour_list::kernels::{Pair, Positions};
use neighbour_list::{Bodies, Contacts, External};

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
    /// Pairs of a pushed particle, counted in `pushed`, and a ghost, counted behind them.
    pairs: Vec<Pair>,
    /// The own particles that ghosts may push, ascending.
    pub(super) pushed: Vec<u32>,
    /// Where the pushed particles are, and behind them the ghosts.
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
        self.pairs.clear();
        let mut ghosts = 0;
        for ((chosen, own), theirs) in self.chosen.iter().zip(&self.sent).zip(&self.received) {
            let pairs = pairs_across(halves(own), halves(theirs), reach);
            let named = pairs.iter().map(|[own, ghost]| [chosen[*own as usize], ghosts + ghost]);
            self.pairs.extend(named);
            ghosts += theirs.len() as u32 / 2;
        }
        self.pushed.extend(self.pairs.iter().map(|[own, _]| *own));
        self.pushed.sort_unstable();
        self.pushed.dedup();
        for [own, ghost] in &mut self.pairs {
            *own = self.pushed.partition_point(|place| place < own) as u32;
            *ghost += self.pushed.len() as u32;
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
    pub(super) fn accelerations(&mut self, observer: &mut impl Observer) -> External<'_> {
        let Self { pairs, received, pushed, x, y, ax, ay, contacts, .. } = self;
        for sums in [&mut *ax, &mut *ay] {
            sums.clear();
            sums.resize(pushed.len(), 0.0);
        }
        for ghosts in received {
            let ghosts = halves(ghosts);
            x.extend_from_slice(ghosts.x);
            y.extend_from_slice(ghosts.y);
        }
        observer.tested(pairs.len() as u64);
        contacts.for_each(pairs, Positions { x, y, first: 0 }, |[own, _], a, r2| {
            ax[own as usize] += a[0];
            ay[own as usize] += a[1];
            observer.seen(r2);
        });
        External { indices: pushed, x: ax, y: ay }
    }
}

/// Positions as they are sent.
fn halves(places: &[f64]) -> Positions<'_> {
    let (x, y) = places.split_at(places.len() / 2);
    Positions { x, y, first: 0 }
}
