//! Zero crossings within a step: the moments at which a number falls through zero.
//!
//! The number is a distance minus the cutoff, or a coordinate minus its wall.

use integrators::Watched;

/// Returns the moment between `low` and `high` at which `value` falls through zero.
///
/// `value` is at least 0 at `low` and below 0 at `high`. The result is at most 10⁻¹² · (`high` − `low`)
/// after the zero crossing, and never before it: `value` is at most 0 at the result.
///
/// Each call of `value` is a Runge-Kutta step of a whole group of particles, so call it rarely. Bisection
/// needs 42 calls, a good method needs a dozen, and more than 30 calls fail the test.
///
/// Two things can go wrong:
///
/// - Both ends of the interval must move inwards. A guess that is an end, or equals it except for
///   rounding, moves neither end, and the next guess is the same. So keep guesses a little away from
///   both ends, by less than half of 10⁻¹² of the whole interval.
/// - `value` may be so close to zero everywhere that its product with a short time is 0. So divide
///   before you multiply.
///
/// Book: chapter 12, *The moment of contact*.
pub fn crossing(low: f64, high: f64, value: &mut dyn FnMut(f64) -> f64) -> f64 {
    todo!("task 12.3: the moment of a zero crossing")
}

/// Returns the first moment from 0 to `h` at which the watched number falls through zero.
///
/// The result is `None` if the number does not fall through zero in this step.
///
/// - `start` and `end`: the value and the slope of the number at 0 and at `h`.
/// - `at`: computes the value and the slope at any moment between 0 and `h`, at the cost of a
///   Runge-Kutta step.
///
/// The step is so short that the slope changes its sign at most once.
///
/// - If the number is at most 0 at the start and its slope is negative, the result is 0.
/// - If the number is at most 0 at the start and rises, an event has just happened. The number falls again
///   only after its top, where the slope falls through zero. If the number is at most 0 at the top, the
///   result is the top itself. If the number rises until the end, the result is `None`, whatever its
///   value at the end.
/// - If the number is above 0 at both ends but first falls and then rises, it may be below 0
///   between the two ends. Check the bottom, where the slope rises through zero.
///
/// The first rule needs a slope below 0. In all other rules, you may treat a slope of exactly 0 as
/// falling or as rising, because both give the same moment.
///
/// Book: chapter 12, *Is there a zero crossing?*.
pub fn first_fall(
    start: Watched,
    end: Watched,
    h: f64,
    at: &mut dyn FnMut(f64) -> Watched,
) -> Option<f64> {
    todo!("task 12.4: a zero crossing within the step")
}
