//! Swept boxes: where a disc can be during a part of the step.

use crate::square::Square;

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
