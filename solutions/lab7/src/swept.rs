//! Task 7.11: where a disc can be during a part of the step.

use crate::{Square, Window};

/// What a disc can touch along one axis: from `low` to `high`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Span {
    /// The least coordinate.
    pub low: f64,
    /// The greatest coordinate.
    pub high: f64,
}

/// How far beyond the path of its centre a disc's box must reach: the radius and a margin for
/// rounding.
///
/// A pair whose candidate time lies in a window must have boxes that overlap in that window, or
/// it is missed. With exact numbers the radius would do. But [`pair_time`] rounds: where two discs
/// graze each other Δ is the small difference of two large numbers. Its error, some ε |d|² |D|²,
/// is an error of √ε |d| in how near they pass and of √ε in the time, with √ε = 1.5e-8. `fastest`
/// bounds |d| (they must get together within a step). A margin of 1e-6 of it is forty times as
/// much, and costs nothing.
///
/// [`pair_time`]: crate::pair_time
pub fn reach(square: Square, fastest: f64) -> f64 {
    square.radius + 1e-6 * (fastest + square.radius) + 1e-14 * square.side
}

/// What a disc with centre `x` and velocity `v` can touch in `window` along one axis, if it flies
/// straight: the interval from the lesser to the greater of its two places at the ends of the
/// window, and `reach` more on both sides.
///
/// The step ends at 1 even if the window goes on.
///
/// Book: chapter 7, *Swept boxes*.
#[inline]
pub fn span(x: f64, v: f64, window: Window, reach: f64) -> Span {
    // task 7.11: the swept box
    let (start, end) = (x + v * window.from, x + v * window.to.min(1.0));
    Span { low: start.min(end) - reach, high: start.max(end) + reach }
    // end 7.11
}
