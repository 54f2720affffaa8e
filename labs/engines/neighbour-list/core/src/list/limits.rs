//! The speed limit that lists are made for, and when the inner list is rebuilt.

use std::ops::Range;
use workers::Workers;

use super::budget::{Budget, lasting};
use super::neighbours::Neighbours;
use super::outliers::{Outlier, Outliers};
use crate::kernels::Primitives;
use crate::particles::{Bodies, Sample};

/// Particles for each one that may be faster than a list allows.
const FEW: usize = 1000;
/// Particles whose speed is looked at to find what is usual.
const SAMPLE: usize = 1024;
/// Beyond n / MANY + A_FEW outliers of n particles, most particles have become faster: a new list should allow for
/// their speed.
const MANY: usize = 50;
const A_FEW: usize = 32;
/// The most times too fast that a particle is expected to be. By a faster one the inner list expires
/// at once: no list should be built for it.
const MOST_OVER: f64 = 2.0;
/// An inner list of m steps is used the first time before any particle has moved, so it has to last
/// for m − 1 displacements, and for a fifth more where a particle is faster than expected.
const BEGINNING: f64 = 0.8;

/// The speed that lists are built for, and the outliers, which are faster.
pub struct Limits {
    /// The speed that the list allows.
    usual: f64,
    /// How far that takes a particle in a step.
    displacement: f64,
    /// Steps that an inner list should last; none if there is no inner list.
    steps: Option<f64>,
    inner: Budget,
    outliers: Outliers,
    /// How many times as fast as allowed the fastest is in a step, on average.
    over: f64,
}

impl Default for Limits {
    fn default() -> Self {
        Self {
            usual: 0.0,
            displacement: 0.0,
            steps: None,
            inner: Budget::default(),
            outliers: Outliers::default(),
            over: 1.0,
        }
    }
}

impl Limits {
    /// Decides for a new list which speed is usual and whether there is to be an inner list, and
    /// returns the list's skin. If a step takes no particle further than `displacement`, then
    /// `skin(displacement)` is best.
    pub fn renew(&mut self, bodies: &Bodies, dt: f64, size: f64, skin: impl Fn(f64) -> f64) -> f64 {
        self.outliers = Outliers::default();
        self.inner = Budget::default();
        let least = 1e-9 * size;
        self.set(Sample::of(bodies, SAMPLE).all_but_one_in(FEW).max(least), dt);
        let thick = skin(self.displacement);
        self.steps = lasting(thick, self.over * self.displacement);
        if self.steps.is_some() {
            return thick;
        }
        self.set(bodies.fastest().max(least), dt);
        skin(self.displacement)
    }

    fn set(&mut self, usual: f64, dt: f64) {
        self.usual = usual;
        self.displacement = usual * dt;
    }

    /// Whether there is an inner list.
    pub fn have_inner(&self) -> bool {
        self.steps.is_some()
    }

    /// Whether the inner list may lack a pair that touches.
    pub fn inner_has_expired<P: Primitives>(&self) -> bool {
        self.have_inner() && self.inner.has_expired::<P>()
    }

    /// How far the usual particle goes in a step.
    pub fn displacement(&self) -> f64 {
        self.displacement
    }

    /// The particles that the lists are not built for.
    pub fn outliers(&self) -> &Outliers {
        &self.outliers
    }

    /// Whether a new list is cheaper, for the number of outliers among `n` particles.
    pub fn are_outrun(&self, n: usize) -> bool {
        self.outliers.count() > n / MANY + A_FEW
    }

    /// The speed limit of the particles in `range`.
    pub fn speed_limit(&self, range: &Range<usize>) -> SpeedLimit<'_> {
        SpeedLimit {
            usual: self.usual,
            noted: self.have_inner(),
            outliers: self.outliers.among(range),
        }
    }

    /// Notes the particles in `range` that are faster than usual, when a list is new. Without an
    /// inner list that does not matter.
    pub fn note_fast(&self, bodies: &Bodies, range: Range<usize>, fast: &mut Fast) {
        fast.indices.clear();
        if self.have_inner() {
            let vx = &bodies.vx[range.clone()];
            let vy = &bodies.vy[range.clone()];
            self.speed_limit(&range).watch(range.start, vx, vy, fast);
        }
    }

    /// Builds the inner list of `list`. The particles of `fast` were faster than usual and are outliers
    /// from now on. Returns how many pairs were tested.
    pub fn rebuild_inner<P: Primitives>(
        &mut self,
        list: &mut Neighbours<P>,
        bodies: &mut Bodies,
        fast: impl Iterator<Item = u32>,
        workers: &Workers,
    ) -> u64 {
        // Periods of equal length: the last inner list should not be built for a step or two.
        // The first step of a list uses it before a particle has moved.
        let left = 0.5 * list.budget.skin - list.budget.displacement;
        let steps_left = 1.0 + left / self.displacement;
        let periods = (steps_left / self.steps.unwrap_or(1.0)).round().max(1.0);
        let moves = steps_left / periods - BEGINNING;
        let skin = 2.0 * (moves * (self.over * self.displacement)).min(left);
        self.inner = Budget::of(skin);
        self.outliers.enter(fast, self.usual, bodies);
        let (more, tested) = self.outliers.pairs(bodies, list, 0.5 * skin, workers);
        let tested = tested + list.rebuild_inner(skin, &more, bodies, workers);
        self.outliers.leave(bodies);
        tested
    }

    /// A step older, in which the fastest was `over` times as fast as allowed and positions were
    /// rounded by `rounding`.
    pub fn age(&mut self, list: &mut Budget, over: f64, rounding: f64) {
        self.over += 0.2 * (over.min(MOST_OVER) - self.over);
        // What outran the list will be an outlier.
        let outrun = if self.have_inner() { 1.0 } else { over };
        list.displacement += outrun * self.displacement + rounding;
        self.inner.displacement += over * self.displacement + rounding;
    }
}

/// Particles that are compared together; few are fast.
const CHUNK: usize = 16;

/// The speeds that a list allows consecutive particles.
#[derive(Clone, Copy)]
pub struct SpeedLimit<'a> {
    /// Of most particles.
    pub usual: f64,
    /// Whether it matters which particles are faster, and not only by how much.
    pub noted: bool,
    /// The outliers, in sorted order, which may be faster.
    pub outliers: &'a [Outlier],
}

/// The particles seen to be faster than usual that are no outliers yet.
pub struct Fast {
    /// Their indices in the sorted order, perhaps more than once.
    pub indices: Vec<u32>,
    /// How many times as fast as allowed the worst of all was in the step, at least 1.
    pub over: f64,
}

impl Default for Fast {
    fn default() -> Self {
        Self { indices: Vec::new(), over: 1.0 }
    }
}

impl SpeedLimit<'_> {
    /// Looks for the fast among particles with these velocities, the first at index `first`.
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

    /// Notes the particles that are faster than usual and no outliers yet.
    #[inline(never)]
    fn note(&self, first: usize, vx: &[f64], vy: &[f64], fast: &mut Fast) {
        for (k, (vx, vy)) in vx.iter().zip(vy).enumerate() {
            let index = (first + k) as u32;
            let square = vx * vx + vy * vy;
            if square > self.usual * self.usual {
                let found = self.outliers.binary_search_by_key(&index, |outlier| outlier.index);
                let ratio = found.map_or(1.0, |k| self.outliers[k].ratio);
                if self.noted && found.is_err() {
                    fast.indices.push(index);
                }
                fast.over = fast.over.max(square.sqrt() / (ratio * self.usual));
            }
        }
    }
}
