//! The border of a rank: own particles that are ghosts elsewhere, ghosts that are here, and the
//! pairs of both.

use common::soft::Observer;
use mpi::Rank;
use neighbour_list::kernels::{Pair, Positions};
use neighbour_list::{Bodies, Contacts, External};

use crate::partition::Strips;
use crate::sent_halo::Halo;

/// What was chosen when the list was rebuilt, and the positions of the step.
#[derive(Default)]
pub(crate) struct Border {
    /// The ranks on the other side.
    pub(crate) partners: Vec<Rank>,
    /// For each partner the indices of the own particles that it needs.
    chosen: Vec<Vec<u32>>,
    /// Their positions: all x, then all y.
    pub(crate) sent: Vec<Vec<f64>>,
    /// The ghosts that each partner sends, in the same form.
    pub(crate) received: Vec<Vec<f64>>,
    /// Pairs of an affected particle, its index in `affected`, and a ghost, counted behind them.
    pairs: Vec<Pair>,
    /// The own particles on which ghosts may exert forces, ascending.
    pub(crate) affected: Vec<u32>,
    /// Where the affected particles are, and behind them the ghosts.
    x: Vec<f64>,
    y: Vec<f64>,
    ax: Vec<f64>,
    ay: Vec<f64>,
    contacts: Contacts,
}

impl Border {
    /// Chooses the ghosts of all `partners`.
    pub(crate) fn choose<T: Halo>(
        &mut self,
        bodies: &Bodies,
        partners: Vec<Rank>,
        strips: &Strips,
        width: f64,
    ) {
        let strips_of = partners.iter().map(|rank| strips.strip(*rank as usize));
        self.chosen = strips_of.map(|strip| T::choose(&bodies.y, &strip, width)).collect();
        self.sent.resize_with(partners.len(), Vec::new);
        self.partners = partners;
        self.affected.clear();
        self.pack(bodies);
    }

    /// How many ghosts are here.
    #[inline]
    pub(crate) fn ghosts(&self) -> usize {
        self.received.iter().map(|positions| positions.len() / 2).sum()
    }

    /// Lists the pairs within `reach` of own particles and the ghosts that came with `received`.
    pub(crate) fn list<T: Halo>(&mut self, received: Vec<Vec<f64>>, reach: f64) {
        self.received = received;
        self.pairs.clear();
        let mut ghosts = 0;
        for (k, chosen) in self.chosen.iter().enumerate() {
            let theirs = &self.received[k];
            let pairs = T::pairs_across(halves(&self.sent[k]), halves(theirs), reach);
            let named = pairs.iter().map(|[own, ghost]| [chosen[*own as usize], ghosts + ghost]);
            self.pairs.extend(named);
            ghosts += theirs.len() as u32 / 2;
        }
        self.affected.extend(self.pairs.iter().map(|[own, _]| *own));
        self.affected.sort_unstable();
        self.affected.dedup();
        for [own, ghost] in &mut self.pairs {
            *own = self.affected.partition_point(|index| index < own) as u32;
            *ghost += self.affected.len() as u32;
        }
    }

    /// Looks where the own particles of the border are now.
    #[inline]
    pub(crate) fn pack(&mut self, bodies: &Bodies) {
        for (to, chosen) in self.sent.iter_mut().zip(&self.chosen) {
            to.clear();
            fetch(to, &bodies.x, chosen);
            fetch(to, &bodies.y, chosen);
        }
        self.x.clear();
        self.y.clear();
        fetch(&mut self.x, &bodies.x, &self.affected);
        fetch(&mut self.y, &bodies.y, &self.affected);
    }

    /// The accelerations of own particles by the ghosts, whose positions have just arrived.
    pub(crate) fn accelerations(&mut self, observer: &mut impl Observer) -> External<'_> {
        let Self { pairs, received, affected, x, y, ax, ay, contacts, .. } = self;
        for sums in [&mut *ax, &mut *ay] {
            sums.clear();
            sums.resize(affected.len(), 0.0);
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
        External { indices: affected, x: ax, y: ay }
    }
}

/// Appends the numbers with these indices in `from`.
#[inline]
fn fetch(to: &mut Vec<f64>, from: &[f64], indices: &[u32]) {
    to.extend(indices.iter().map(|index| from[*index as usize]));
}

/// Positions as they are sent.
#[inline]
fn halves(positions: &[f64]) -> Positions<'_> {
    let (x, y) = positions.split_at(positions.len() / 2);
    Positions { x, y, first: 0 }
}
