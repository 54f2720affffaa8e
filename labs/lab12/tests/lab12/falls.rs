//! Questions about numbers that fall through zero within a step, and about the times of their
//! falls.

use integrators::Watched;
use lab12::first_fall;
use oracle::{Ask, Random};

use super::moments::Search;

/// Random numbers from which the parabolas of a case are made, as parts of a step.
struct Draw {
    /// A time within the step, and a time before it.
    s: f64,
    before: f64,
    gap: f64,
    dip: f64,
    /// Delay, within rounding, with which an event is noticed.
    late: f64,
}

impl Draw {
    fn new(random: &mut Random) -> Self {
        let s = random.between(0.05, 0.95);
        Self {
            s,
            before: s * random.between(0.1, 0.9),
            gap: random.magnitude(1e-9, 0.5),
            dip: s * random.magnitude(1e-3, 0.5),
            late: random.magnitude(1e-17, 1e-13),
        }
    }
}

/// A kind of number: its name, and its parabola c + d s + e s².
type Kind = (&'static str, fn(&Draw) -> [f64; 3]);

/// Name of a number whose end is not below zero, so that it need not be evaluated within the step.
const NOT_FAR_ENOUGH: &str = "falls, but not to zero";

/// Numbers whose falls can be decided from the two ends of a step.
const DECIDED_AT_THE_ENDS: [Kind; 8] = [
    (NOT_FAR_ENOUGH, |d| [1.0 + d.gap, -1.0, 0.0]),
    ("rises", |d| [d.gap, d.s, 0.0]),
    ("starts at zero and rises", |d| [0.0, d.s, 0.0]),
    ("starts slightly below zero because of rounding, and rises", |d| [-d.late, d.s, 0.0]),
    ("starts slightly below zero because of rounding, and falls", |d| [-d.late, -d.s, 0.0]),
    ("starts at zero and falls", |d| [0.0, -d.s, 1.0]),
    ("rises all the way, but stays below zero", |d| [-1.0 - d.gap, 1.0, 0.0]),
    ("stays slightly above zero", |d| [1e-9 + d.gap, -1e-12, 0.0]),
];

/// Numbers that must be evaluated within the step.
const DECIDED_INSIDE: [Kind; 15] = [
    ("falls", |d| [d.s, -1.0, 0.0]),
    ("dips below zero and comes back", |d| [d.before * d.s, -d.before - d.s, 1.0]),
    ("dips slightly below zero and comes back", |d| [d.s * d.s - d.dip * d.dip, -2.0 * d.s, 1.0]),
    ("comes near zero and rises again", |d| [d.s * d.s + d.gap, -2.0 * d.s, 1.0]),
    ("rises and then falls", |d| [d.before * d.s, d.s - d.before, -1.0]),
    ("rises and then falls, but not to zero", |d| [d.gap, 1.0, -1.0]),
    ("starts at zero, rises, and then falls", |d| [0.0, d.s, -1.0]),
    ("starts slightly below zero because of rounding, rises, and then falls", |d| {
        [-d.late * d.s, d.s, -1.0]
    }),
    ("starts below zero, rises above zero, and then falls", |d| {
        [-(d.s - d.dip) * d.dip, d.s, -1.0]
    }),
    ("rises to zero, but not above it", |_| [-0.25, 1.0, -1.0]),
    ("starts level, and then falls", |d| [d.s * d.s, 0.0, -1.0]),
    ("starts level at zero, and then falls", |d| [0.0, 0.0, -d.s]),
    ("starts level at zero, and then rises", |d| [0.0, 0.0, d.s]),
    ("falls, and ends level and below zero", |d| [1.0 - d.s * d.s, -2.0, 1.0]),
    ("never gets above zero", |d| [-d.gap - d.s * d.s, 2.0 * d.s, -1.0]),
];

/// A number that changes along a parabola, in any units. If the number is bent, all times except
/// for both ends are earlier, so that its curve is not a parabola.
struct Number {
    kind: &'static str,
    parabola: [f64; 3],
    bend: f64,
    size: f64,
    h: f64,
}

impl Number {
    fn drawn(random: &mut Random, kinds: &[Kind], case: usize) -> Self {
        let (kind, parabola) = kinds[case % kinds.len()];
        Self {
            kind,
            parabola: parabola(&Draw::new(random)),
            bend: [0.0, random.between(0.1, 2.0)][case / kinds.len() % 2],
            size: random.magnitude(1e-100, 1e100),
            h: random.magnitude(1e-12, 1e12),
        }
    }

    fn question(&self) -> String {
        let Self { kind, parabola: [c, d, e], bend, size, h } = self;
        format!(
            "a number that {kind}. In a step of {h:?} it is {size:e} × ({c:?} + {d:?} s + {e:?} s²), with s = (1 + b) \
             t / (1 + b t) and b = {bend:?}, and t is the time as a part of the step: (1) number of evaluations, (2) \
             number of evaluations outside the step, (3) the t at which the number falls through zero, or nothing if \
             it does not fall"
        )
    }

    /// Returns the number at a time `t`.
    fn at(&self, t: f64) -> Watched {
        let [c, d, e] = self.parabola;
        let t = t / self.h;
        let faster = (1.0 + self.bend) / (1.0 + self.bend * t);
        let s = faster * t;
        let slope = (d + 2.0 * s * e) * faster / (1.0 + self.bend * t);
        Watched { value: self.size * (c + s * (d + s * e)), slope: self.size * (slope / self.h) }
    }

    fn search(&self) -> Vec<f64> {
        let mut search = Search::new();
        let fall = first_fall(self.at(0.0), self.at(self.h), self.h, &mut |t| {
            search.look(t, 0.0, self.h);
            self.at(t)
        });
        let mut numbers = search.numbers();
        numbers.extend(fall.map(|t| t / self.h));
        numbers
    }

    /// Returns the time of the fall, as a part of the step. `None` if the number does not fall.
    fn right(&self) -> Option<f64> {
        let [c, d, e] = self.parabola;
        if c <= 0.0 && d < 0.0 {
            return Some(0.0);
        }
        // The number falls at the lesser zero of a parabola that opens upwards, and at the greater
        // zero of a parabola that opens downwards.
        let root = (d * d - 4.0 * c * e).max(0.0).sqrt();
        let s = if e == 0.0 { -c / d } else { (-d - root) / (2.0 * e) };
        let falls = if e == 0.0 { d < 0.0 } else { e < 0.0 || root > 0.0 };
        (falls && (0.0..=1.0).contains(&s)).then(|| s / (1.0 + self.bend - self.bend * s))
    }

    fn verdict(&self, found: &[f64]) -> Result<(), String> {
        let [looks, outside, fall @ ..] = found else {
            return Err("the answer is not complete".into());
        };
        if *outside > 0.0 {
            return Err(format!("{outside} evaluations were outside the step"));
        }
        if *looks > 100.0 || self.kind == NOT_FAR_ENOUGH && *looks > 0.0 {
            return Err(format!("there were {looks} evaluations, which are more than necessary"));
        }
        let right = self.right();
        // A number that begins with a fall falls at exactly 0.
        let most = if right == Some(0.0) && self.parabola[1] != 0.0 { 0.0 } else { 1e-11 };
        match (fall, right) {
            ([], None) => Ok(()),
            ([fall], Some(right)) if (fall - right).abs() <= most => Ok(()),
            _ => Err(format!("     found: {fall:?}\n  expected: {:?}", Vec::from_iter(right))),
        }
    }
}

fn falls(random: &mut Random, ask: &mut impl Ask, kinds: &[Kind]) {
    for case in 0..180 * kinds.len() {
        let number = Number::drawn(random, kinds, case);
        ask.judge(&number.question(), || number.search(), |found| number.verdict(found));
    }
}

pub(crate) fn decided_at_the_ends(random: &mut Random, ask: &mut impl Ask) {
    falls(random, ask, &DECIDED_AT_THE_ENDS);
}

/// Asks about numbers that must be evaluated within the step. Every second number is bent.
pub(crate) fn decided_inside(random: &mut Random, ask: &mut impl Ask) {
    falls(random, ask, &DECIDED_INSIDE);
}

pub(crate) fn a_touch(_: &mut Random, ask: &mut impl Ask) {
    let at = |t: f64| Watched { value: (t - 1.0) * (t - 1.0), slope: 2.0 * (t - 1.0) };
    let question = "(t - 1)² in a step of length 2, which touches 0: time at which it falls through zero, or no \
                    number if it does not";
    ask.exact(
        question,
        || first_fall(at(0.0), at(2.0), 2.0, &mut |t| at(t)).into_iter().collect(),
        Vec::new,
    );
}
