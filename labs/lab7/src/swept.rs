//! Task 7.11: the space that a disc sweeps in a part of the step.

use hard_discs::{Span, Window};

/// Returns the interval that a disc can touch during `window` along one axis.
///
/// The disc starts the step with its centre at `x` and velocity `v`, and flies straight. The
/// interval reaches from the lesser to the greater of its positions at the two ends of the window,
/// and extends further by `reach` on both sides.
///
/// The step ends at 1, even if the window continues.
///
/// Book: chapter 7, *Swept boxes*.
#[inline]
pub fn span(x: f64, v: f64, window: Window, reach: f64) -> Span {
    todo!("task 7.11: the swept box")
}
