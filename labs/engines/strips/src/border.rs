//! The border of a rank: its particles that are ghosts on other ranks, its ghosts, and their pairs.

use common::soft::Observer;
use mpi::Rank;
use neighbour_list::kernels::{Pair, Positions};
use neighbour_list::{Bodies, Contacts, External};

use crate::partition::Strips;
use crate::sent_halo::Halo;

/// The ghosts that were chosen when the list was rebuilt, and the positions of the current step.
#[derive(Default)]
pub(crate) struct Border {
    /// The ranks that exchange ghosts with this rank.
    pub(crate) partners: Vec<Rank>,
    /// For each partner, the indices of this rank's particles that the partner needs.
    chosen: Vec<Vec<u32>>,
    /// The positions of these particles: all x, then all y.
    pub(crate) sent: Vec<Vec<f64>>,
    /// The positions of the ghosts that each partner sends, in the same form.
    pub(crate) received: Vec<Vec<f64>>,
    /// Pairs of an affected particle and a ghost: the index in `affected`, and an index in `x` and
    /// `y`.
    pairs: Vec<Pair>,
    /// The particles of this rank that ghosts may exert forces on, ascending.
    pub(crate) affected: Vec<u32>,
    /// The positions of the affected particles, followed by the positions of the ghosts.
    x: Vec<f64>,
    y: Vec<f64>,
    ax: Vec<f64>,
    ay: Vec<f64>,
    contacts: Contacts,
}

impl Border {
    /// Chooses the particles that each partner needs.
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

    /// Returns the number of ghosts that this rank has.
    #[inline]
    pub(crate) fn ghosts(&self) -> usize {
        self.received.iter().map(|positions| positions.len() / 2).sum()
    }

    /// Lists the pairs of a particle of this rank and a ghost in `received` that are within
    /// `reach`.
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

    /// Copies the positions of this rank's particles at the border.
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

    /// Returns the accelerations of this rank's particles due to ghosts, whose positions have just
    /// arrived.
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

/// Appends the elements of `from` with these indices.
#[inline]
fn fetch(to: &mut Vec<f64>, from: &[f64], indices: &[u32]) {
    to.extend(indices.iter().map(|index| from[*index as usize]));
}

/// Splits the positions of a message into x and y. All x come first in a message.
#[inline]
fn halves(positions: &[f64]) -> Positions<'_> {
    let (x, y) = positions.split_at(positions.len() / 2);
    Positions { x, y, first: 0 }
}
