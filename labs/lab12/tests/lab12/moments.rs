//! Questions about the time at which a number falls through zero.

use common::soft::DT;
use lab12::crossing;
use oracle::{Ask, Random, truth};

/// Number of evaluations after which a search is considered endless.
const WITHOUT_END: usize = 10_000;

/// The answer to a search: the time, and the number and places of evaluations.
pub(crate) struct Search {
    looks: usize,
    outside: usize,
}

impl Search {
    pub(crate) fn new() -> Self {
        Self { looks: 0, outside: 0 }
    }

    /// Counts an evaluation at the time `t` of an interval from `low` to `high`.
    pub(crate) fn look(&mut self, t: f64, low: f64, high: f64) {
        self.looks += 1;
        assert!(
            self.looks < WITHOUT_END,
            "{WITHOUT_END} evaluations, but the function still does not return"
        );
        self.outside += usize::from(!(low..=high).contains(&t));
    }

    /// Returns the number of evaluations, and the number of evaluations outside the interval.
    pub(crate) fn numbers(&self) -> Vec<f64> {
        vec![self.looks as f64, self.outside as f64]
    }
}

/// A number that falls through zero between two times.
struct Falling {
    kind: usize,
    low: f64,
    high: f64,
    /// Position of the zero, as a part of the interval.
    root: f64,
    /// Exponent of the curve.
    power: f64,
    size: f64,
}

const KINDS: [&str; 5] =
    ["a line", "a parabola", "a late fall", "an early fall", "a rise from zero and a fall"];

impl Falling {
    fn drawn(random: &mut Random, case: usize) -> Self {
        let stretch = if case.is_multiple_of(7) { DT } else { random.magnitude(1e-12, 1e12) };
        let low = [0.0, stretch * random.magnitude(1e-3, 1e3)][random.below(2)];
        let near_an_end = [
            random.between(0.0, 1.0),
            random.magnitude(1e-6, 0.5),
            1.0 - random.magnitude(1e-6, 0.5),
        ];
        let root = match case % 5 {
            0 | 1 => near_an_end[random.below(3)],
            _ => random.between(0.3, 0.99),
        };
        let power = random.between(2.0, 9.0);
        let size = random.magnitude(1e-250, 1e250);
        let falling = Self { kind: case % 5, low, high: low + stretch, root, power, size };
        // Rounds the root as a time is rounded.
        Self { root: falling.part(low + root * (falling.high - low)), ..falling }
    }

    /// Returns a time as a part of the interval.
    fn part(&self, t: f64) -> f64 {
        (t - self.low) / (self.high - self.low)
    }

    fn value(&self, t: f64) -> f64 {
        let Self { root, power, .. } = *self;
        let t = self.part(t);
        let value = match self.kind {
            0 => root - t,
            1 => (root + power - t).powi(2) - power * power,
            2 => root.powf(power) - t.powf(power),
            3 => (-power * t).exp() - (-power * root).exp(),
            _ => t * (root - t),
        };
        self.size * value
    }

    /// Returns whether the ends of the interval are valid for a search.
    fn falls(&self) -> bool {
        self.value(self.low) >= 0.0 && self.value(self.high) < 0.0
    }

    /// Searches for the zero. Returns the time as a part of the interval, the number at this time,
    /// and the counts of evaluations.
    fn search(&self) -> Vec<f64> {
        let mut search = Search::new();
        let moment = crossing(self.low, self.high, &mut |t| {
            search.look(t, self.low, self.high);
            self.value(t)
        });
        [vec![self.part(moment), self.value(moment)], search.numbers()].concat()
    }

    fn verdict(&self, found: &[f64]) -> Result<(), String> {
        let &[part, value, looks, outside] = found else {
            return Err("the answer is not complete".into());
        };
        let late = (part - self.root) / 1e-12;
        if late.is_nan() || late.abs() > 3.0 {
            return Err(format!(
                "the function found the moment {part:?} instead of {:?}, both as a part of the interval. The \
                 difference is {late:.1e} × 10^-12",
                self.root
            ));
        }
        if value > 0.0 {
            return Err(format!(
                "at the moment that the function found, the number is {value:e}, which is above zero"
            ));
        }
        if outside > 0.0 {
            return Err(format!("{outside} evaluations were outside the interval"));
        }
        if looks > 30.0 {
            return Err(format!("there were {looks} evaluations, but at most 30 are allowed"));
        }
        Ok(())
    }
}

/// Asks about numbers that fall steeply at the beginning or at the end, from exactly zero, early
/// and late, in any units.
pub(crate) fn crossings(random: &mut Random, ask: &mut impl Ask) {
    for case in 0..3000 {
        let falling = Falling::drawn(random, case);
        if !falling.falls() {
            continue;
        }
        let Falling { kind, low, high, root, size, .. } = falling;
        let question = format!(
            "{} of size {size:e}, from the time {low:?} to {high:?}. It falls through zero at the moment {root:?}, as \
             a part of the interval: (1) the moment that the function finds, as a part of the interval, (2) the \
             number at this moment, (3) number of evaluations, (4) number of evaluations outside the interval",
            KINDS[kind]
        );
        ask.judge(&question, || falling.search(), |found| falling.verdict(found));
    }
}

/// Asks about lines so near to zero that a product of two numbers may be 0.
pub(crate) fn faint_crossings(_: &mut Random, ask: &mut impl Ask) {
    for size in [1e-300, 1e-308, 1e-315, 1e-320] {
        for root in [0.25, 0.75] {
            let question = format!(
                "a line of size {size:e}, from the time 0 to 1e-9. It falls through zero at the moment {root}, as a \
                 part of the interval: (1) 1 if the line is at most 0 at the moment that the function finds, 0 if \
                 not, (2) this moment, as a part of the interval"
            );
            // The smallest number that is not 0 is 5e-324.
            let latest = || root + 3e-12 + 1e-323 / size;
            ask.judge(
                &question,
                || faint_crossing(size, root),
                |found| match found {
                    [1.0, part] if *part <= latest() => Ok(()),
                    _ => Err(format!(
                        "     found: {found:?}\n  expected: (1) 1, (2) at most {}",
                        latest()
                    )),
                },
            );
        }
    }
}

fn faint_crossing(size: f64, root: f64) -> Vec<f64> {
    let value = |t: f64| size * (root - t / 1e-9);
    let mut search = Search::new();
    let moment = crossing(0.0, 1e-9, &mut |t| {
        search.look(t, 0.0, 1e-9);
        value(t)
    });
    vec![truth(value(moment) <= 0.0), moment / 1e-9]
}
