//! Times within a step at which a distance crosses the cutoff, or a coordinate crosses a wall.

/// The value of a function at some time, and its slope. The function is at least 0 until the event.
#[derive(Clone, Copy, Debug)]
pub(super) struct Watched {
    pub(super) value: f64,
    pub(super) slope: f64,
}

/// Returns the first time in (0, h] at which a function falls through zero. `None` if there is no
/// such time. `at` evaluates the function anywhere in the step. The step is so short that the slope
/// changes sign at most once.
pub(super) fn first_fall(
    start: Watched,
    end: Watched,
    h: f64,
    mut at: impl FnMut(f64) -> Watched,
) -> Option<f64> {
    if start.slope <= 0.0 && start.value <= 0.0 {
        return Some(0.0);
    }
    let (low, high) = match (start.slope <= 0.0, end.slope < 0.0) {
        (_, true) if end.value >= 0.0 => return None,
        (true, true) => (0.0, h),
        // The function rises and then falls, so the crossing is after the maximum.
        (false, true) => (root(0.0, h, |t| -at(t).slope), h),
        // The function falls and then rises: it may be below zero in between.
        (true, false) => {
            let bottom = root(0.0, h, |t| at(t).slope);
            if at(bottom).value >= 0.0 {
                return None;
            }
            (0.0, bottom)
        }
        (false, false) => return None,
    };
    Some(root(low, high, |t| -at(t).value))
}

/// Returns the zero of a function that is at most 0 at `low` and positive at `high`: regula falsi
/// with the Illinois rule.
fn root(mut low: f64, mut high: f64, mut f: impl FnMut(f64) -> f64) -> f64 {
    let (mut below, mut above) = (f(low), f(high));
    if below >= 0.0 {
        return low;
    }
    let mut last = 0;
    for round in 0..200 {
        let middle = 0.5 * (low + high);
        if high - low <= 1e-18 || middle <= low || middle >= high || above <= 0.0 {
            break;
        }
        // Occasional bisections ensure progress for every shape.
        let chord = low + (high - low) * (-below / (above - below));
        let guess = if round % 3 == 2 || chord <= low || chord >= high { middle } else { chord };
        let value = f(guess);
        if value == 0.0 {
            return guess;
        }
        if value < 0.0 {
            if last < 0 {
                above *= 0.5;
            }
            (last, low, below) = (-1, guess, value);
        } else {
            if last > 0 {
                below *= 0.5;
            }
            (last, high, above) = (1, guess, value);
        }
    }
    high
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parabola(t: f64, depth: f64) -> Watched {
        Watched { value: (t - 0.5) * (t - 0.5) - depth, slope: 2.0 * (t - 0.5) }
    }

    #[test]
    fn a_dip_is_found_and_a_near_miss_is_none() {
        let fall = |depth| {
            first_fall(parabola(0.0, depth), parabola(1.0, depth), 1.0, |t| parabola(t, depth))
        };
        for depth in [1e-2, 1e-6, 1e-12] {
            let found = fall(depth).expect("the number dips below zero");
            assert!((found - (0.5 - depth.sqrt())).abs() < 1e-11, "{depth}: {found}");
        }
        assert_eq!(fall(-1e-12), None);
    }

    #[test]
    fn a_value_that_rises_first_falls_later() {
        // The function rises from a rounding error below zero, then falls permanently.
        let at = |t: f64| Watched { value: t * (0.4 - t) - 1e-18, slope: 0.4 - 2.0 * t };
        let found = first_fall(at(0.0), at(1.0), 1.0, at).unwrap();
        assert!((found - 0.4).abs() < 1e-14, "{found}");
    }
}
