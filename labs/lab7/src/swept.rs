//! Task 7.11: where a disc can be during a part of the step.

use hard_discs::{Span, Window};

/// What a disc with centre `x` and velocity `v` can touch in `window` along one axis, if it flies
/// straight: the interval from the lesser to the greater of its two positions at the ends of the
/// window, and `reach` more on both sides.
///
/// The step ends at 1 even if the window goes on.
///
/// Book: chapter 7, *Swept boxes*.
#[inline]
pub fn span(x: f64, v: f64, window: Window, reach: f64) -> Span {
    todo!("task 7.11: the swept box")
}
