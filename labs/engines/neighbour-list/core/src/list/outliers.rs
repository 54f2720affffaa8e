//! Outliers: the few particles that are too fast for a list.
//!
//! A list that allows for the fastest particle would expire early for all particles. Among 100,000
//! particles, the fastest is 1.5 times as fast as all but a hundred particles. So the list is built
//! for the usual speed. In the time in which a usual particle goes at most d, an outlier goes at
//! most ratio · d:
//!
//! ```text
//! usual ●─▶   ◀─● usual        in the inner list if closer than cutoff + d + d
//! usual ●─▶   ◀────● outlier   found by `Outliers::pairs` if closer than cutoff + d + ratio · d
//! ```
//!
//! The pairs of outliers are searched whenever an inner list is built.

use std::ops::Range;
use workers::Workers;

use super::neighbours::Neighbours;
use crate::kernels::{Pair, Primitives};
use crate::particles::Bodies;
use crate::threads::pieces;

/// Number of outliers whose pairs a thread searches one after another.
const OUTLIERS_PER_TASK: usize = 32;

/// A particle that has exceeded the speed of its list.
#[derive(Clone, Copy)]
pub struct Outlier {
    /// The particle's index in the sorted order.
    pub index: u32,
    x: f64,
    y: f64,
    /// The particle's speed limit for the life of the inner list, as a multiple of the usual speed.
    pub ratio: f64,
}

/// All outliers, in sorted order.
#[derive(Default)]
pub struct Outliers {
    all: Vec<Outlier>,
}

impl Outliers {
    /// Returns the number of outliers.
    pub fn count(&self) -> usize {
        self.all.len()
    }

    /// Returns the indices of the outliers.
    pub fn indices(&self) -> impl Iterator<Item = u32> {
        self.all.iter().map(|outlier| outlier.index)
    }

    /// Returns the greatest speed limit of an outlier as a multiple of the usual speed, at least 1.
    pub fn fastest(&self) -> f64 {
        self.all.iter().fold(1.0, |most, outlier| most.max(outlier.ratio))
    }

    /// Returns the outliers with indices in `range`.
    pub fn among(&self, range: &Range<usize>) -> &[Outlier] {
        let before = |end| self.all.partition_point(|outlier| (outlier.index as usize) < end);
        &self.all[before(range.start)..before(range.end)]
    }

    /// Adds the particles `new`, and records the position and the speed limit of every outlier.
    ///
    /// The x of an outlier is NaN until it [`leaves`](Outliers::leave). So a search for usual
    /// particles does not find outliers.
    pub fn enter(&mut self, new: impl Iterator<Item = u32>, usual: f64, bodies: &mut Bodies) {
        let before = self.all.len();
        self.all.extend(new.map(|index| Outlier { index, x: 0.0, y: 0.0, ratio: 1.0 }));
        if self.all.len() > before {
            // The earlier outliers are in order already.
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

    /// Restores the positions of the outliers in `bodies`.
    pub fn leave(&self, bodies: &mut Bodies) {
        for outlier in &self.all {
            bodies.x[outlier.index as usize] = outlier.x;
        }
    }

    /// Returns the pairs with an outlier that may touch before a usual particle has gone
    /// `displacement`.
    ///
    /// The pairs are in order. The second value is the number of pairs that were tested.
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
        // The first task finds the pairs of two outliers. Every other task finds the pairs of some
        // outliers with usual particles.
        let some = self.all.chunks(pieces(self.all.len(), OUTLIERS_PER_TASK, 64)).map(Some);
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
    /// Finds the outlier's pairs with usual particles.
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
        // The cells were computed from the positions when the list was built.
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
    /// Centre along x.
    pub x: f64,
    /// Centre along y.
    pub y: f64,
    /// Radius.
    pub radius: f64,
    /// The particle's index.
    pub index: u32,
}

impl Disc {
    /// Returns the least x of the disc.
    fn left(&self) -> f64 {
        self.x - self.radius
    }
}

/// Returns the pairs of `discs` that overlap, and the number of pairs that were tested.
///
/// The lower index of a pair is first.
///
/// Along x a disc can overlap only the discs that begin before it ends.
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
