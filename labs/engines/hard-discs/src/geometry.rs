//! The square, windows of time, and the place of a disc in a window.

use common::hard::Scene;

/// The square and the radius of the discs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Square {
    /// Side L of the square.
    pub side: f64,
    /// Radius r of every disc.
    pub radius: f64,
}

impl Square {
    /// Returns the square of a scene.
    pub fn of(scene: &Scene) -> Self {
        Self { side: scene.side(), radius: scene.radius() }
    }

    /// Returns the least coordinate of a centre: r.
    #[inline]
    pub fn least(&self) -> f64 {
        self.radius
    }

    /// Returns the greatest coordinate of a centre: L − r.
    #[inline]
    pub fn most(&self) -> f64 {
        self.side - self.radius
    }
}

/// A part of the step: all times t with `from` ≤ t < `to`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Window {
    /// Start of the window, as a part λ of the step.
    pub from: f64,
    /// End of the window.
    pub to: f64,
}

impl Window {
    /// The whole step, its end included.
    pub const STEP: Self = Self { from: 0.0, to: f64::INFINITY };

    /// Returns window `k` of `count` equal windows. The last window includes the end of the step.
    pub fn part(k: usize, count: usize) -> Self {
        let to = if k + 1 == count { f64::INFINITY } else { (k + 1) as f64 / count as f64 };
        Self { from: k as f64 / count as f64, to }
    }

    /// Whether the window contains a time.
    #[inline]
    pub fn contains(&self, time: f64) -> bool {
        self.from <= time && time < self.to
    }
}

/// The coordinates along one axis that a disc can touch: from `low` to `high`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Span {
    /// The least coordinate.
    pub low: f64,
    /// The greatest coordinate.
    pub high: f64,
}

/// Returns the distance that a disc's box must extend beyond the path of the centre.
///
/// The distance is the radius and a margin. `fastest` is the greatest velocity component of the
/// scene. The boxes of a pair must overlap in the window of its candidate time, or the pair is
/// missed. In exact arithmetic the radius would be enough. However, [`pair_hit`] rounds: if two
/// discs graze each other, Δ is the small difference of two large numbers. Its error of about ε
/// |d|² |D|² causes an error of √ε |d| in the least distance and of √ε in the time, with √ε =
/// 1.5e-8. `fastest` bounds |d|, because the discs must meet within a step. A margin of 1e-6 times
/// `fastest` is forty times as large as the error, and costs nothing.
///
/// [`pair_hit`]: crate::Collisions::pair_hit
pub fn reach(square: Square, fastest: f64) -> f64 {
    square.radius + 1e-6 * (fastest + square.radius) + 1e-14 * square.side
}
