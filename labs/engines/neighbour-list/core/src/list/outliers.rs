//! Particles that are too fast for a list.
//!
//! By the fastest of all a list would expire for all, and of a hundred thousand particles it is half
//! as fast again as all but a hundred. So the list is made for most particles, and the pairs of the
//! outliers are looked for whenever an inner list is built.

use std::ops::Range;
use workers::Workers;

use super::neighbours::Neighbours;
use crate::kernels::{Pair, Primitives};
use crate::particles::Bodies;
use crate::threads::pieces;

/// Outliers whose pairs are looked for one after another.
const SOME: usize = 32;

/// A particle that was once faster than its list allows.
#[derive(Clone, Copy)]
pub struct Outlier {
    /// Its index in the sorted order.
    pub index: u32,
    x: f64,
    y: f64,
    /// How many times faster than usual it may be while the inner list lasts.
    pub ratio: f64,
}

/// All of them, in sorted order.
#[derive(Default)]
pub struct Outliers {
    all: Vec<Outlier>,
}

impl Outliers {
    /// How many there are.
    pub fn count(&self) -> usize {
        self.all.len()
    }

    /// Their indices.
    pub fn indices(&self) -> impl Iterator<Item = u32> {
        self.all.iter().map(|outlier| outlier.index)
    }

    /// How many times faster than usual any of them may be, at least 1.
    pub fn fastest(&self) -> f64 {
        self.all.iter().fold(1.0, |most, outlier| most.max(outlier.ratio))
    }

    /// The outliers with indices in `range`.
    pub fn among(&self, range: &Range<usize>) -> &[Outlier] {
        let before = |end| self.all.partition_point(|outlier| (outlier.index as usize) < end);
        &self.all[before(range.start)..before(range.end)]
    }

    /// Adds `new` ones, and sees where all are and how much faster than `usual`. Until they
    /// [`leave`](Outliers::leave) no search finds them: their x is no number.
    pub fn enter(&mut self, new: impl Iterator<Item = u32>, usual: f64, bodies: &mut Bodies) {
        let before = self.all.len();
        self.all.extend(new.map(|index| Outlier { index, x: 0.0, y: 0.0, ratio: 1.0 }));
        if self.all.len() > before {
            // Earlier outliers are in order.
            self.all.sort_by_key(|outlier| outlier.index);
            self.all.dedup_by_key(|outlier| outlier.index);
        }
        for outlier in &mut self.all {
            let i = outlier.index as usize;
            let vx = bodies.vx[i];
            let vy = bodies.vy[i];
            outlier.x = bodies.x[i];
            outlier.y = bodies.y[i];
            outlier.ratio = ((vx * vx + vy * vy).sqrt() / usual).max(1.0);
            bodies.x[i] = f64::NAN;
        }
    }

    /// Gives them their positions back.
    pub fn leave(&self, bodies: &mut Bodies) {
        for outlier in &self.all {
            bodies.x[outlier.index as usize] = outlier.x;
        }
    }

    /// All pairs with an outlier that may touch before the usual particle has gone `displacement`,
    /// in order, and how many were looked at.
    pub fn pairs<P: Primitives>(
        &self,
        bodies: &Bodies,
        list: &Neighbours<P>,
        displacement: f64,
        workers: &Workers,
    ) -> (Vec<Pair>, u64) {
        let disc = |outlier: &Outlier| {
            let Outlier { index, x, y, ratio } = *outlier;
            Disc { x, y, radius: 0.5 * list.reach(2.0 * ratio * displacement), index }
        };
        // Pairs of two outliers, and piece by piece pairs of an outlier and a usual particle.
        let some = self.all.chunks(pieces(self.all.len(), SOME, 64)).map(Some);
        let found = workers.map(std::iter::once(None).chain(some).collect(), |some| {
            let Some(some): Option<&[Outlier]> = some else {
                return overlapping(self.all.iter().map(disc).collect());
            };
            let mut found = (Vec::new(), 0);
            some.iter()
                .for_each(|outlier| outlier.look_around(bodies, list, displacement, &mut found));
            found
        });
        let tested = found.iter().map(|(_, tested)| tested).sum();
        let mut pairs: Vec<Pair> = found.into_iter().flat_map(|(pairs, _)| pairs).collect();
        pairs.sort_unstable();
        (pairs, tested)
    }
}

impl Outlier {
    /// Its pairs with usual particles.
    fn look_around<P: Primitives>(
        &self,
        bodies: &Bodies,
        list: &Neighbours<P>,
        displacement: f64,
        (found, tested): &mut (Vec<Pair>, u64),
    ) {
        let Some(cells) = &list.cells else { return };
        let Outlier { index, x, y, ratio } = *self;
        let reach = list.reach(displacement + ratio * displacement);
        // The cells know where a particle was when the list was built.
        let pad = reach + list.budget.displacement;
        let mut rows = cells.rows_of(&[x - pad, x + pad, y - pad, y + pad]);
        while let Some(range) = rows.next(cells) {
            *tested += range.len() as u64;
            for k in range {
                let dx = bodies.x[k] - x;
                let dy = bodies.y[k] - y;
                if dx * dx + dy * dy <= reach * reach {
                    found.push([index.min(k as u32), index.max(k as u32)]);
                }
            }
        }
    }
}

/// A disc around a particle.
#[derive(Clone, Copy)]
pub struct Disc {
    /// Its centre along x.
    pub x: f64,
    /// Its centre along y.
    pub y: f64,
    /// Its radius.
    pub radius: f64,
    /// The particle.
    pub index: u32,
}

impl Disc {
    /// The least x of the disc.
    fn left(&self) -> f64 {
        self.x - self.radius
    }
}

/// The pairs of `discs` that overlap, the lower index first, and how many pairs were looked at.
///
/// Along x a disc can only overlap discs that begin before it ends.
pub fn overlapping(mut discs: Vec<Disc>) -> (Vec<[u32; 2]>, u64) {
    discs.sort_unstable_by(|a, b| a.left().total_cmp(&b.left()).then(a.index.cmp(&b.index)));
    let mut found = Vec::new();
    let mut tested = 0;
    for (k, a) in discs.iter().enumerate() {
        let right = a.x + a.radius;
        for b in discs[k + 1..].iter().take_while(|b| b.left() <= right) {
            tested += 1;
            let dx = b.x - a.x;
            let dy = b.y - a.y;
            let far = a.radius + b.radius;
            if dx * dx + dy * dy <= far * far {
                found.push([a.index.min(b.index), a.index.max(b.index)]);
            }
        }
    }
    (found, tested)
}
