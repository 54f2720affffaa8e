//! The square that discs are in, windows of time, and where a disc can be in one.

use common::hard::Scene;

/// The square and the radius.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Square {
    /// Side L of the square.
    pub side: f64,
    /// Radius r of every disc.
    pub radius: f64,
}

impl Square {
    /// The square of a scene.
    pub fn of(scene: &Scene) -> Self {
        Self { side: scene.side(), radius: scene.radius() }
    }

    /// The least coordinate of a centre: r.
    #[inline]
    pub fn least(&self) -> f64 {
        self.radius
    }

    /// The greatest coordinate of a centre: L − r.
    #[inline]
    pub fn most(&self) -> f64 {
        self.side - self.radius
    }
}

/// A part of the step: the times from `from` up to, but without, `to`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Window {
    /// Where it begins, as a part λ of the step.
    pub from: f64,
    /// Where it ends.
    pub to: f64,
}

impl Window {
    /// The whole step, its end included.
    pub const STEP: Self = Self { from: 0.0, to: f64::INFINITY };

    /// Window `k` of `count` equal ones. The last one includes the end of the step.
    pub fn part(k: usize, count: usize) -> Self {
        let to = if k + 1 == count { f64::INFINITY } else { (k + 1) as f64 / count as f64 };
        Self { from: k as f64 / count as f64, to }
    }

    /// Whether a time lies in it.
    #[inline]
    pub fn contains(&self, time: f64) -> bool {
        self.from <= time && time < self.to
    }
}

/// What a disc can touch along one axis: from `low` to `high`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Span {
    /// The least coordinate.
    pub low: f64,
    /// The greatest coordinate.
    pub high: f64,
}

/// How far beyond the path of its centre a disc's box must reach: the radius and a margin for
/// rounding. `fastest` is the greatest velocity component of the scene.
///
/// A pair whose candidate time lies in a window must have boxes that overlap in that window, or
/// it is missed. With exact numbers the radius would do. But [`pair_hit`] rounds: where two discs
/// graze each other Δ is the small difference of two large numbers. Its error, some ε |d|² |D|²,
/// is an error of √ε |d| in how near they pass and of √ε in the time, with √ε = 1.5e-8. `fastest`
/// bounds |d| (they must get together within a step). A margin of 1e-6 of it is forty times as
/// much, and costs nothing.
///
/// [`pair_hit`]: crate::Collisions::pair_hit
pub fn reach(square: Square, fastest: f64) -> f64 {
    square.radius + 1e-6 * (fastest + square.radius) + 1e-14 * square.side
}
