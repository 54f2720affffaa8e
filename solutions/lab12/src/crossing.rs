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
    // task 12.3: the moment at which something falls through zero
    let close = 1e-12 * (high - low);
    let (mut low, mut high) = (low, high);
    let (mut above, mut below) = (value(low), value(high));
    let mut stayed = 0;
    for _ in 0..100 {
        if high - low <= close || below == 0.0 {
            break;
        }
        // Where the chord falls through, kept a little away from both ends so that both close in;
        // the middle if the numbers are too large to say.
        let share = above / (above - below);
        let share = if share.is_finite() { share } else { 0.5 };
        let guess = (low + (high - low) * share).clamp(low + 0.4 * close, high - 0.4 * close);
        let found = value(guess);
        if found > 0.0 {
            (low, above) = (guess, found);
            // Illinois: an end that stays twice counts half, so that the chord comes over to it.
            below *= if stayed == 1 { 0.5 } else { 1.0 };
            stayed = 1;
        } else {
            (high, below) = (guess, found);
            above *= if stayed == -1 { 0.5 } else { 1.0 };
            stayed = -1;
        }
    }
    high
    // end 12.3
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
    // task 12.4: whether something falls within the step
    if start.value <= 0.0 && start.slope < 0.0 {
        return Some(0.0);
    }
    let falls = |slope: f64| slope <= 0.0;
    match (falls(start.slope), falls(end.slope)) {
        (_, true) if end.value >= 0.0 => None,
        (true, true) => Some(crossing(0.0, h, &mut |t| at(t).value)),
        // It rises and then falls: the crossing lies behind the top.
        (false, true) => {
            let top = crossing(0.0, h, &mut |t| at(t).slope);
            (at(top).value > 0.0).then(|| crossing(top, h, &mut |t| at(t).value)).or(Some(top))
        }
        // It falls and then rises: it may dip below zero.
        (true, false) => {
            let bottom = crossing(0.0, h, &mut |t| -at(t).slope);
            (at(bottom).value < 0.0).then(|| crossing(0.0, bottom, &mut |t| at(t).value))
        }
        (false, false) => None,
    }
    // end 12.4
}
