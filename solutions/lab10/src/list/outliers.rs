//! Particles that are too fast for a list.
//!
//! The fastest of all would wear a list out for everybody, and of a hundred thousand it is half as
//! fast again as all but a hundred. So the list is made for the others, and these look around for
//! themselves whenever it is shortened.

use std::ops::Range;

use super::neighbours::Neighbours;
use crate::kernels::Pair;
use crate::particles::Bodies;
use crate::threads::{Workers, pieces};

/// Runners that look around one after another.
const SOME: usize = 32;

/// A particle that was once faster than its list allows.
#[derive(Clone, Copy)]
pub struct Runner {
    /// Its place in the sorted order.
    pub who: u32,
    x: f64,
    y: f64,
    /// How many times faster than usual it may be while the short list lasts.
    pub ratio: f64,
}

/// All of them, in sorted order.
#[derive(Default)]
pub struct Runners {
    all: Vec<Runner>,
}

impl Runners {
    /// How many there are.
    pub fn len(&self) -> usize {
        self.all.len()
    }

    /// Their places.
    pub fn places(&self) -> impl Iterator<Item = u32> {
        self.all.iter().map(|runner| runner.who)
    }

    /// How many times faster than usual any of them may be, at least 1.
    pub fn fastest(&self) -> f64 {
        self.all.iter().fold(1.0, |most, runner| most.max(runner.ratio))
    }

    /// Those with places in `range`.
    pub fn among(&self, range: &Range<usize>) -> &[Runner] {
        let before = |end| self.all.partition_point(|runner| (runner.who as usize) < end);
        &self.all[before(range.start)..before(range.end)]
    }

    /// Adds `new` ones, and sees where all are and how much faster than `usual`. Until they
    /// [`leave`](Runners::leave) nobody sees them: their x is no number.
    pub fn enter(&mut self, new: impl Iterator<Item = u32>, usual: f64, bodies: &mut Bodies) {
        let before = self.all.len();
        self.all.extend(new.map(|who| Runner { who, x: 0.0, y: 0.0, ratio: 1.0 }));
        if self.all.len() > before {
            // Those who ran before are in order.
            self.all.sort_by_key(|runner| runner.who);
            self.all.dedup_by_key(|runner| runner.who);
        }
        for runner in &mut self.all {
            let i = runner.who as usize;
            let (vx, vy) = (bodies.vx[i], bodies.vy[i]);
            (runner.x, runner.y) = (bodies.x[i], bodies.y[i]);
            runner.ratio = ((vx * vx + vy * vy).sqrt() / usual).max(1.0);
            bodies.x[i] = f64::NAN;
        }
    }

    /// Gives them their places back.
    pub fn leave(&self, bodies: &mut Bodies) {
        for runner in &self.all {
            bodies.x[runner.who as usize] = runner.x;
        }
    }

    /// All pairs with a runner that may touch before the usual particle has gone `way`, in order,
    /// and how many were looked at.
    pub fn pairs(
        &self,
        bodies: &Bodies,
        list: &Neighbours,
        way: f64,
        workers: &Workers,
    ) -> (Vec<Pair>, u64) {
        let disc = |runner: &Runner| {
            let Runner { who, x, y, ratio } = *runner;
            Disc { x, y, radius: 0.5 * list.reach(2.0 * ratio * way), who }
        };
        // Those with each other, and piece by piece those with all who are no runners.
        let some = self.all.chunks(pieces(self.all.len(), SOME, 64)).map(Some);
        let found = workers.map(std::iter::once(None).chain(some).collect(), |some| {
            let Some(some): Option<&[Runner]> = some else {
                return overlapping(self.all.iter().map(disc).collect());
            };
            let mut found = (Vec::new(), 0);
            some.iter().for_each(|runner| runner.look_around(bodies, list, way, &mut found));
            found
        });
        let tested = found.iter().map(|(_, tested)| tested).sum();
        let mut pairs: Vec<Pair> = found.into_iter().flat_map(|(pairs, _)| pairs).collect();
        pairs.sort_unstable();
        (pairs, tested)
    }
}

impl Runner {
    /// Its pairs with all who are no runners.
    fn look_around(
        &self,
        bodies: &Bodies,
        list: &Neighbours,
        way: f64,
        (found, tested): &mut (Vec<Pair>, u64),
    ) {
        let Some(cells) = &list.cells else { return };
        let Runner { who, x, y, ratio } = *self;
        let reach = list.reach(way + ratio * way);
        // The cells know where somebody was when the list was made.
        let pad = reach + list.wear.way;
        let mut rows = cells.rows_of(&[x - pad, x + pad, y - pad, y + pad]);
        while let Some(range) = rows.next(cells) {
            *tested += range.len() as u64;
            for k in range {
                let (dx, dy, k) = (bodies.x[k] - x, bodies.y[k] - y, k as u32);
                if dx * dx + dy * dy <= reach * reach {
                    found.push([who.min(k), who.max(k)]);
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
    pub who: u32,
}

/// The pairs of `discs` that overlap, the lower number first, and how many were looked at.
///
/// Along x a disc can only overlap those that begin before it ends.
pub fn overlapping(mut discs: Vec<Disc>) -> (Vec<[u32; 2]>, u64) {
    let left = |disc: &Disc| disc.x - disc.radius;
    discs.sort_unstable_by(|a, b| left(a).total_cmp(&left(b)).then(a.who.cmp(&b.who)));
    let (mut found, mut tested) = (Vec::new(), 0);
    for (k, a) in discs.iter().enumerate() {
        let right = a.x + a.radius;
        for b in discs[k + 1..].iter().take_while(|b| left(b) <= right) {
            tested += 1;
            let (dx, dy, far) = (b.x - a.x, b.y - a.y, a.radius + b.radius);
            if dx * dx + dy * dy <= far * far {
                found.push([a.who.min(b.who), a.who.max(b.who)]);
            }
        }
    }
    (found, tested)
}
