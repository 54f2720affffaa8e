//! The decisions that the engine leaves to its user.

use crate::span::Span;

/// The decisions that windows depend on.
///
/// Each decision may be wrong in one direction only. A rule may wrongly claim that two particles
/// may meet, that a wall may be near, that a pair may have been missed, or that a window should be
/// short. This costs time, but no bit of the result changes.
///
/// The engine calls the rules in its innermost loops: mark short rules with `#[inline(always)]`.
pub trait Rules: Send + 'static {
    /// Advances one coordinate `x` of particles in free flight by `steps` steps of length `dt`.
    ///
    /// `v` contains a velocity for each coordinate. The result has the same bits as `x += v * dt`,
    /// repeated `steps` times. No wall is near.
    fn fly(x: &mut [f64], v: &[f64], steps: u32, dt: f64);

    /// Returns the square of the least distance between two points within time `span`, or a smaller
    /// number.
    ///
    /// At first the points are (`dx`, `dy`) apart. The second moves with velocity (`wx`, `wy`)
    /// relative to the first.
    fn closest_squared(dx: f64, dy: f64, wx: f64, wy: f64, span: f64) -> f64;

    /// Returns the least number in the group of number `k`.
    ///
    /// For each number, `parent` contains a number of the same group that is not greater. The least
    /// number of a group is its own parent.
    fn root(parent: &mut [u32], k: u32) -> u32;

    /// Unites the groups of `a` and `b`, which may be the same group.
    fn join(parent: &mut [u32], a: u32, b: u32);

    /// Whether two particles may have come within the cutoff, although their free flights did not.
    ///
    /// Each of the particles deviates from its free flight by at most `deviation`. The free flights
    /// stay further apart than cutoff + `margin`. Both arguments are lengths.
    fn too_far_off(deviation: f64, margin: f64) -> bool;

    /// Whether the free flight from (`x`, `y`) with velocity (`vx`, `vy`) may touch a wall within
    /// the window.
    ///
    /// The result is also true if the flight ends within [`Span::rounding`] of a wall, and for
    /// numbers that are NaN.
    fn meets_wall(span: &Span, x: f64, y: f64, vx: f64, vy: f64) -> bool;

    /// Returns the number of official steps that a window should have, at least 1.
    ///
    /// There are `density` particles per unit area, and their mean speed is `speed`.
    fn window_length(density: f64, speed: f64) -> u32;
}
