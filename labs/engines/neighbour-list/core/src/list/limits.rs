//! The speed that lists are built for, and the times at which the inner list is rebuilt.

use std::ops::Range;
use workers::Workers;

use super::budget::{Budget, lasting};
use super::neighbours::Neighbours;
use super::outliers::{Outlier, Outliers};
use crate::kernels::Primitives;
use crate::particles::{Bodies, Sample};

/// Number of particles per fast particle. Fast particles exceed the speed that a new list is made
/// for.
const PARTICLES_PER_FAST_PARTICLE: usize = 1000;
/// Number of particles whose speeds are sampled.
const SAMPLE: usize = 1024;
/// Number of particles per outlier that a list tolerates.
///
/// If there are more outliers, most particles have become faster, and a new list that allows for
/// their speed is cheaper.
const PARTICLES_PER_OUTLIER: usize = 50;
/// Number of additional outliers that a list tolerates, even with few particles.
const SPARE_OUTLIERS: usize = 32;
/// The greatest factor by which the fastest particle is expected to exceed the speed limit.
///
/// A faster particle makes the inner list expire immediately. No list is built for such a speed.
const MAX_SPEED_RATIO: f64 = 2.0;
/// Displacements that an inner list saves: m steps use up m − `SAVED_DISPLACEMENTS` displacements.
///
/// The first step uses the list before any particle has moved, which saves one displacement. A
/// fifth of this displacement is kept for particles that are faster than expected.
const SAVED_DISPLACEMENTS: f64 = 0.8;

/// The speed that lists are built for, and the outliers, which are faster than this speed.
pub struct Limits {
    /// The speed that a particle may have without being an outlier.
    usual: f64,
    /// The distance that a particle moves in a step at the speed `usual`.
    displacement: f64,
    /// Number of steps that an inner list should last; `None` if there is no inner list.
    steps: Option<f64>,
    inner: Budget,
    outliers: Outliers,
    /// Speed of the fastest particle as a multiple of the allowed speed, averaged over recent
    /// steps.
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
    /// Chooses the usual speed for a new list, and decides whether to use inner lists. Returns the
    /// list's skin.
    ///
    /// `skin(displacement)` is the best skin if no particle moves further than `displacement` in a
    /// step.
    pub fn renew(&mut self, bodies: &Bodies, dt: f64, size: f64, skin: impl Fn(f64) -> f64) -> f64 {
        self.outliers = Outliers::default();
        self.inner = Budget::default();
        let least = 1e-9 * size;
        self.set(
            Sample::of(bodies, SAMPLE).all_but_one_in(PARTICLES_PER_FAST_PARTICLE).max(least),
            dt,
        );
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

    /// Whether the inner list may lack a pair in contact.
    pub fn inner_has_expired<P: Primitives>(&self) -> bool {
        self.have_inner() && self.inner.has_expired::<P>()
    }

    /// Returns the distance that a particle of the usual speed goes in a step.
    pub fn displacement(&self) -> f64 {
        self.displacement
    }

    /// Returns the particles that are too fast for the lists.
    pub fn outliers(&self) -> &Outliers {
        &self.outliers
    }

    /// Whether there are so many outliers among `n` particles that a new list is cheaper.
    pub fn are_outrun(&self, n: usize) -> bool {
        self.outliers.count() > n / PARTICLES_PER_OUTLIER + SPARE_OUTLIERS
    }

    /// Returns the speed limit for the particles in `range`.
    pub fn speed_limit(&self, range: &Range<usize>) -> SpeedLimit<'_> {
        SpeedLimit {
            usual: self.usual,
            noted: self.have_inner(),
            outliers: self.outliers.among(range),
        }
    }

    /// Records in `fast` the particles in `range` that are faster than usual, when a list is new.
    ///
    /// Without an inner list there are no outliers, so nothing is recorded.
    pub fn note_fast(&self, bodies: &Bodies, range: Range<usize>, fast: &mut Fast) {
        fast.indices.clear();
        if self.have_inner() {
            let vx = &bodies.vx[range.clone()];
            let vy = &bodies.vy[range.clone()];
            self.speed_limit(&range).watch(range.start, vx, vy, fast);
        }
    }

    /// Builds the inner list of `list`. The particles in `fast` are outliers from now on.
    ///
    /// Returns the number of pairs that were tested.
    pub fn rebuild_inner<P: Primitives>(
        &mut self,
        list: &mut Neighbours<P>,
        bodies: &mut Bodies,
        fast: impl Iterator<Item = u32>,
        workers: &Workers,
    ) -> u64 {
        // The remaining steps are divided into equal periods, so that no inner list is built for
        // the last one or two steps only. A list is first used before any particle has moved, so it
        // lasts one step longer.
        let left = 0.5 * list.budget.skin - list.budget.displacement;
        let steps_left = 1.0 + left / self.displacement;
        let periods = (steps_left / self.steps.unwrap_or(1.0)).round().max(1.0);
        let moves = steps_left / periods - SAVED_DISPLACEMENTS;
        let skin = 2.0 * (moves * (self.over * self.displacement)).min(left);
        self.inner = Budget::of(skin);
        self.outliers.enter(fast, self.usual, bodies);
        let (more, tested) = self.outliers.pairs(bodies, list, 0.5 * skin, workers);
        let tested = tested + list.rebuild_inner(skin, &more, bodies, workers);
        self.outliers.leave(bodies);
        tested
    }

    /// Ages both lists by a step.
    ///
    /// In this step the fastest particle went `over` times the allowed distance, and rounding moved
    /// positions by at most `rounding`.
    pub fn age(&mut self, list: &mut Budget, over: f64, rounding: f64) {
        self.over += 0.2 * (over.min(MAX_SPEED_RATIO) - self.over);
        // With an inner list, the particle that was too fast becomes an outlier and does not age
        // the outer list.
        let outrun = if self.have_inner() { 1.0 } else { over };
        list.displacement += outrun * self.displacement + rounding;
        self.inner.displacement += over * self.displacement + rounding;
    }
}

/// Number of particles that are compared together. Few chunks contain a fast particle.
const CHUNK: usize = 16;

/// The speeds that a list allows for consecutive particles.
#[derive(Clone, Copy)]
pub struct SpeedLimit<'a> {
    /// The limit for all particles that are not outliers.
    pub usual: f64,
    /// Whether to record the faster particles themselves, in addition to the factor by which they
    /// are faster.
    pub noted: bool,
    /// The outliers, which have higher limits, in sorted order.
    pub outliers: &'a [Outlier],
}

/// The particles that have exceeded the usual speed and are not outliers yet.
pub struct Fast {
    /// The indices of these particles in the sorted order. An index may occur more than once.
    pub indices: Vec<u32>,
    /// The greatest speed in the step as a multiple of the allowed speed, at least 1.
    pub over: f64,
}

impl Default for Fast {
    fn default() -> Self {
        Self { indices: Vec::new(), over: 1.0 }
    }
}

impl SpeedLimit<'_> {
    /// Records the fast particles among those with these velocities; the first has index `first`.
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

    /// Records the particles of a chunk that are faster than usual and not outliers yet.
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
