//! When something falls through zero within a step: a distance less the cutoff, a coordinate less
//! its wall.

use integrators::Watched;

/// The moment between `low` and `high` at which `value` falls through zero. It is at least 0 at
/// `low` and below 0 at `high`. What comes out is at most 10⁻¹² · (`high` − `low`) behind that moment,
/// and never before it: `value` is at most 0 there.
///
/// Each look at `value` is a Runge-Kutta step of a whole group of particles, so few looks are
/// wanted: halving takes 42 of them, a good method a dozen, and more than 30 are too many.
///
/// Both ends of the stretch must close in. A guess that lands on an end, or within rounding of it, moves
/// nothing, and the next one is the same: keep guesses a little away from both ends, by less than half of
/// 10⁻¹² of the whole stretch. And `value` may be so near to zero everywhere that its product with a short time
/// is 0: divide first.
///
/// Book: chapter 12, *The moment of contact*.
pub fn crossing(low: f64, high: f64, value: &mut dyn FnMut(f64) -> f64) -> f64 {
    todo!("task 12.3: the moment at which something falls through zero")
}

/// The first moment from 0 to `h` at which the watched number falls through zero, if it does.
///
/// `start` is its value and slope at 0, `end` at `h`, and `at` computes them anywhere between, for the
/// price of a Runge-Kutta step. The step is so short that the slope changes its sign at most once
/// in it.
///
/// - A number at 0 or below at the start, with a negative slope, falls at once: 0.
/// - A number at 0 or below at the start that rises has just been through an event. It falls again
///   only behind its top, where the slope falls through zero; at the top itself, if the number is no
///   higher than 0 there. If it rises to the end there is no fall, wherever it ends.
/// - A number above 0 at both ends may still dip below 0 between them, if it falls at first and
///   rises at last: look at the bottom, where the slope rises through zero.
///
/// A slope of exactly 0 may be taken for falling or for rising: both find the same moment. Only the first rule needs
/// one below 0.
///
/// Book: chapter 12, *Is there a zero crossing?*.
pub fn first_fall(
    start: Watched,
    end: Watched,
    h: f64,
    at: &mut dyn FnMut(f64) -> Watched,
) -> Option<f64> {
    todo!("task 12.4: whether something falls within the step")
}
