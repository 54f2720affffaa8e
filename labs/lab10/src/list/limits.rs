//! How far particles may go before a list is worn out, and its short list.

use std::ops::Range;

use super::budget::{Wear, lasting};
use super::neighbours::Neighbours;
use super::outliers::{Runner, Runners};
use crate::particles::{Bodies, Sample};
use crate::threads::Workers;

/// One in so many particles is faster than a list allows.
const FEW: usize = 1000;
/// Particles whose speed is looked at to find what is usual.
const SAMPLE: usize = 1024;
/// More than one runner in so many particles, and a few: then the others are faster than when the list was
/// made, and it should be made for them.
const MANY: usize = 50;
const A_FEW: usize = 32;
/// How many times too fast somebody is expected to be at most. Who is faster wears the short list
/// out at once; nobody should prepare for that.
const MOST_OVER: f64 = 2.0;
/// A short list of m steps is used the first time before anybody has gone, so it has to last for
/// m − 1 ways, and for a fifth more when somebody is faster than expected.
const BEGINNING: f64 = 0.8;

/// The speed that lists are made for, and who is faster.
pub struct Limits {
    /// The speed that wears the list out.
    usual: f64,
    /// How far that takes a particle in a step.
    way: f64,
    /// Steps that a short list should last; none if there is no short list.
    steps: Option<f64>,
    short: Wear,
    runners: Runners,
    /// How many times as fast as allowed the fastest is in a step, on average.
    over: f64,
}

impl Default for Limits {
    fn default() -> Self {
        Self {
            usual: 0.0,
            way: 0.0,
            steps: None,
            short: Wear::default(),
            runners: Runners::default(),
            over: 1.0,
        }
    }
}

impl Limits {
    /// Decides for a new list which speed is usual and whether there is to be a short list, and
    /// brings back the list's skin. If a step takes nobody further than `way`, then `skin(way)` is
    /// best, and a pair matters when it lacks twice `ahead(way)` to touch.
    pub fn renew(
        &mut self,
        bodies: &Bodies,
        dt: f64,
        size: f64,
        ahead: impl Fn(f64) -> f64,
        skin: impl Fn(f64) -> f64,
    ) -> f64 {
        (self.runners, self.short) = (Runners::default(), Wear::default());
        let least = 1e-9 * size;
        self.set(Sample::of(bodies, SAMPLE).all_but_one_in(FEW).max(least), dt);
        let thick = skin(self.way);
        let expected = self.over * self.way;
        self.steps = lasting(thick, expected, ahead(expected));
        if self.steps.is_some() {
            return thick;
        }
        self.set(bodies.fastest().max(least), dt);
        skin(self.way)
    }

    fn set(&mut self, usual: f64, dt: f64) {
        (self.usual, self.way) = (usual, usual * dt);
    }

    /// Whether there is a short list.
    pub fn are_short(&self) -> bool {
        self.steps.is_some()
    }

    /// Whether a new short list is due: a pair that it lacks may matter before anybody has gone
    /// `ahead` further.
    pub fn short_is_out(&self, ahead: f64) -> bool {
        self.are_short() && self.short.is_out(ahead)
    }

    /// How far the usual particle goes in a step.
    pub fn way(&self) -> f64 {
        self.way
    }

    /// Who looks around for itself.
    pub fn runners(&self) -> &Runners {
        &self.runners
    }

    /// Whether so many of `n` particles run that a new list is cheaper.
    pub fn are_outrun(&self, n: usize) -> bool {
        self.runners.len() > n / MANY + A_FEW
    }

    /// What is allowed to the particles in `range`.
    pub fn pace(&self, range: &Range<usize>) -> Pace<'_> {
        let (usual, noted) = (self.usual, self.are_short());
        Pace { usual, noted, runners: self.runners.among(range) }
    }

    /// Looks who of the particles in `range` is faster than usual, when a list is new. Without a
    /// short list nobody asks.
    pub fn look(&self, bodies: &Bodies, range: Range<usize>, fast: &mut Fast) {
        fast.who.clear();
        if self.are_short() {
            let (vx, vy) = (&bodies.vx[range.clone()], &bodies.vy[range.clone()]);
            self.pace(&range).watch(range.start, vx, vy, fast);
        }
    }

    /// Shortens `list`, which has to look as far `ahead` as for [`Limits::renew`]. Whoever is in
    /// `fast` was faster than usual and runs from now on. Brings back how many pairs were looked at.
    pub fn shorten(
        &mut self,
        list: &mut Neighbours,
        bodies: &mut Bodies,
        fast: impl Iterator<Item = u32>,
        ahead: impl Fn(f64) -> f64,
        workers: &Workers,
    ) -> u64 {
        // Periods of equal length: the last short list should not be made for a step or two.
        // The first step of a list uses it before anybody has gone.
        let left = 0.5 * list.wear.skin - list.wear.way;
        let steps_left = 1.0 + (left - ahead(self.way)) / self.way;
        let periods = (steps_left / self.steps.unwrap_or(1.0)).round().max(1.0);
        let ways = steps_left / periods - BEGINNING;
        let expected = self.over * self.way;
        let skin = 2.0 * (ahead(expected) + ways * expected).min(left);
        self.short = Wear::of(skin);
        self.runners.enter(fast, self.usual, bodies);
        let (more, tested) = self.runners.pairs(bodies, list, 0.5 * skin, workers);
        let tested = tested + list.shorten(skin, &more, bodies, workers);
        self.runners.leave(bodies);
        tested
    }

    /// A step older, in which somebody was `over` times as fast as allowed and places were
    /// rounded by `rounding`.
    pub fn age(&mut self, list: &mut Wear, over: f64, rounding: f64) {
        self.over += 0.2 * (over.min(MOST_OVER) - self.over);
        // Who outran the list will look around for itself.
        let outrun = if self.are_short() { 1.0 } else { over };
        list.way += outrun * self.way + rounding;
        self.short.way += over * self.way + rounding;
    }
}

/// Particles that are compared together; few are fast.
const CHUNK: usize = 16;

/// The speeds that a list allows consecutive particles.
#[derive(Clone, Copy)]
pub struct Pace<'a> {
    /// Of most particles.
    pub usual: f64,
    /// Whether it matters who is faster, and not only how much.
    pub noted: bool,
    /// Those that may be faster, in sorted order.
    pub runners: &'a [Runner],
}

/// Who was seen to be faster than usual, and is no runner yet.
pub struct Fast {
    /// Their places in the sorted order, perhaps more than once.
    pub who: Vec<u32>,
    /// How many times as fast as allowed the worst of all was in the step, at least 1.
    pub over: f64,
}

impl Default for Fast {
    fn default() -> Self {
        Self { who: Vec::new(), over: 1.0 }
    }
}

impl Pace<'_> {
    /// Looks for the fast among particles with these velocities, the first in place `first`.
    #[inline(always)]
    pub fn watch(&self, first: usize, vx: &[f64], vy: &[f64], fast: &mut Fast) {
        for (k, (vx, vy)) in vx.chunks(CHUNK).zip(vy.chunks(CHUNK)).enumerate() {
            let mut any = false;
            for (vx, vy) in vx.iter().zip(vy) {
                any |= vx * vx + vy * vy > self.usual * self.usual;
            }
            if any {
                self.note(first + k * CHUNK, vx, vy, fast);
            }
        }
    }

    #[inline(never)]
    fn note(&self, first: usize, vx: &[f64], vy: &[f64], fast: &mut Fast) {
        for (k, (vx, vy)) in vx.iter().zip(vy).enumerate() {
            self.judge((first + k) as u32, vx * vx + vy * vy, fast);
        }
    }

    /// Notes a particle if the square of its speed is more than usual and it does not run yet.
    #[inline(always)]
    pub fn judge(&self, who: u32, square: f64, fast: &mut Fast) {
        if square > self.usual * self.usual {
            let place = self.runners.binary_search_by_key(&who, |runner| runner.who);
            let ratio = place.map_or(1.0, |k| self.runners[k].ratio);
            if self.noted && place.is_err() {
                fast.who.push(who);
            }
            fast.over = fast.over.max(square.sqrt() / (ratio * self.usual));
        }
    }
}
