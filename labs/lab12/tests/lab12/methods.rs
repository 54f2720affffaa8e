//! Questions about compositions and about Runge-Kutta methods, with random inputs.

use common::Vec2;
use integrators::State;
use lab12::{CHI, Composition, LAMBDA, Motion, XI, slopes};
use oracle::{Ask, Near, Random, integers};

/// A record of the requested drifts (0) and kicks (1). Drifts and kicks of zero duration are not
/// recorded.
#[derive(Default)]
struct Record(Vec<f64>);

impl Motion for Record {
    fn drift(&mut self, dt: f64) {
        self.0.extend([0.0, dt].iter().filter(|_| dt != 0.0));
    }

    fn kick(&mut self, dt: f64) {
        self.0.extend([1.0, dt].iter().filter(|_| dt != 0.0));
    }
}

/// Asks about few and many drifts and kicks, also back in time, some of zero duration, all
/// different.
pub(crate) fn steps(random: &mut Random, ask: &mut impl Ask) {
    for kicks in random.sizes(33).into_iter().flat_map(|kicks| [kicks; 8]) {
        let drifts = fractions(random, kicks + 1);
        let composition = Composition { drifts, kicks: fractions(random, kicks) };
        let dt = random.magnitude(1e-12, 1e12);
        let question = format!(
            "a step of {dt:?}, {composition:?}: its drifts (0) and kicks (1) in their order, each with its time. A \
             time of 0 is left out"
        );
        let found = || {
            let mut record = Record::default();
            composition.step(&mut record, dt);
            record.0
        };
        ask.near(&question, found, || by_turns(&composition, dt));
    }
}

/// Draws fractions of a step, some of them 0.
fn fractions(random: &mut Random, n: usize) -> Vec<f64> {
    let fraction = |_| if random.below(5) == 0 { 0.0 } else { random.signed(1e-6, 1e3) };
    (0..n).map(fraction).collect()
}

/// Returns the correct content of a [`Record`].
fn by_turns(composition: &Composition, dt: f64) -> Vec<Near> {
    let mut all = Vec::new();
    for (k, &drift) in composition.drifts.iter().enumerate() {
        all.push([0.0, drift * dt]);
        all.extend(composition.kicks.get(k).map(|&kick| [1.0, kick * dt]));
    }
    let near = |right: f64| Near { right, scale: right.abs() };
    all.into_iter().filter(|[_, time]| *time != 0.0).flatten().map(near).collect()
}

/// Returns the numbers of drifts and kicks, followed by their fractions.
fn numbers(Composition { drifts, kicks }: Composition) -> Vec<f64> {
    [integers([drifts.len(), kicks.len()]), drifts, kicks].concat()
}

pub(crate) fn velocity_verlet(_: &mut Random, ask: &mut impl Ask) {
    let question = "velocity Verlet (half a kick, a drift, half a kick), written as alternating drifts and kicks: (1) \
                    number of drifts, (2) number of kicks, (3) the drifts, (4) the kicks";
    let found = || numbers(Composition::velocity_verlet());
    ask.exact(question, found, || vec![3.0, 2.0, 0.0, 1.0, 0.0, 0.5, 0.5]);
}

pub(crate) fn pefrl(_: &mut Random, ask: &mut impl Ask) {
    let question = "PEFRL, made from its first drift XI, its second drift CHI and its second kick LAMBDA: (1) number \
                    of drifts, (2) number of kicks, (3) the drifts, (4) the kicks";
    ask.judge(question, || numbers(Composition::pefrl()), is_pefrl);
}

/// Checks that a composition has PEFRL's numbers, is symmetric, and adds up to a step.
fn is_pefrl(found: &[f64]) -> Result<(), String> {
    let Some(([5.0, 4.0], fractions)) = found.split_first_chunk() else {
        return Err(format!("there must be 5 drifts and 4 kicks: {found:?}"));
    };
    let (drifts, kicks) = fractions.split_at(5);
    if [drifts[0], drifts[1], kicks[1]] != [XI, CHI, LAMBDA] {
        return Err(format!("the given numbers are in the wrong places: {drifts:?}, {kicks:?}"));
    }
    for (what, fractions) in [("drifts", drifts), ("kicks", kicks)] {
        if !fractions.iter().eq(fractions.iter().rev()) {
            return Err(format!("the {what} must be the same in reverse order: {fractions:?}"));
        }
        let sum: f64 = fractions.iter().sum();
        if (sum - 1.0).abs() > 1e-14 {
            return Err(format!("the {what} {fractions:?} add up to {sum}, but must add up to 1"));
        }
    }
    Ok(())
}

/// Particles in a ring. Each particle is pulled by its own position, by the next particle, and by a
/// constant.
struct Ring {
    start: State,
    pull: Vec<f64>,
    h: f64,
    /// Magnitude of positions.
    unit: f64,
}

impl Ring {
    fn drawn(random: &mut Random, n: usize) -> Self {
        let unit = random.magnitude(1e-9, 1e9);
        let h = random.magnitude(1e-9, 1e9);
        let start = State { at: vectors(random, n, unit), v: vectors(random, n, unit / h) };
        let pull = (0..n).map(|_| random.signed(0.01, 1.0) / (h * h)).collect();
        Self { start, pull, h, unit }
    }

    /// Writes the accelerations of particles at these positions.
    fn accelerate(&self, at: &[Vec2], a: &mut [Vec2]) {
        for (i, a) in a.iter_mut().enumerate() {
            let next = at[(i + 1) % at.len()];
            let always = (0.5 * self.pull[i]) * Vec2::new(-at[i].y, 1.0);
            *a = self.pull[i] * (next - at[i]) + always;
        }
    }

    /// Returns the four correct evaluations.
    fn right(&self) -> Looks {
        let n = self.pull.len();
        let zero = vec![Vec2::ZERO; n];
        let mut looks = Looks { at: Vec::new(), sum: State { at: zero.clone(), v: zero } };
        let mut stage = self.start.clone();
        for (weight, next) in [(1.0, 0.5), (2.0, 0.5), (2.0, 1.0), (1.0, 0.0)] {
            looks.at.push(stage.at.clone());
            let mut slope = State { at: stage.v, v: vec![Vec2::ZERO; n] };
            self.accelerate(&stage.at, &mut slope.v);
            looks.sum = looks.sum.along(&slope, weight);
            stage = self.start.along(&slope, next * self.h);
        }
        looks
    }
}

/// Draws vectors in any direction.
fn vectors(random: &mut Random, n: usize, size: f64) -> Vec<Vec2> {
    let vector = |_| size * Vec2::new(random.signed(0.1, 1.0), random.signed(0.1, 1.0));
    (0..n).map(vector).collect()
}

/// The positions that a Runge-Kutta step evaluates, and the weighted sum of its slopes.
struct Looks {
    at: Vec<Vec<Vec2>>,
    sum: State,
}

/// Asks for Runge-Kutta steps of no, few and many particles in a ring.
pub(crate) fn runge_kutta(random: &mut Random, ask: &mut impl Ask) {
    for n in random.sizes(4097).into_iter().chain([70_000]) {
        let ring = Ring::drawn(random, n);
        let mut at = Vec::new();
        let sum = slopes(&ring.start, ring.h, &mut |positions, a| {
            at.push(positions.to_vec());
            ring.accelerate(positions, a);
        });
        let looks = Looks { at, sum };
        let name = format!("{n} particles in a ring, a step of {:?}", ring.h);
        let question = format!("{name}: number of evaluations");
        ask.exact(&question, || integers([looks.at.len()]), || vec![4.0]);
        for k in 0..4 {
            let question = format!("{name}: x and y of each particle in evaluation {}", k + 1);
            let found = || looks.at.get(k).map_or(vec![], |at| flat(at));
            ask.near(&question, found, || nearly(&ring.right().at[k], ring.unit));
        }
        let question = format!("{name}: weighted sum of the velocities: x and y for each particle");
        let scale = ring.unit / ring.h;
        ask.near(&question, || flat(&looks.sum.at), || nearly(&ring.right().sum.at, scale));
        let question =
            format!("{name}: weighted sum of the accelerations: x and y for each particle");
        let scale = scale / ring.h;
        ask.near(&question, || flat(&looks.sum.v), || nearly(&ring.right().sum.v, scale));
    }
}

fn flat(all: &[Vec2]) -> Vec<f64> {
    all.iter().flat_map(|v| [v.x, v.y]).collect()
}

fn nearly(all: &[Vec2], scale: f64) -> Vec<Near> {
    flat(all).into_iter().map(|right| Near { right, scale }).collect()
}
