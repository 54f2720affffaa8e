//! What tests and probe ask alike about methods and events, with drawn inputs and what a plain model says.

use common::Vec2;
use common::soft::DT;
use integrators::{State, Watched};
use lab12::{Composition, Motion, crossing, first_fall, slopes};

use super::ask::{Ask, rounded, truth};
use crate::Random;

/// Writes down the drifts (0) and kicks (1) that are asked of it; one for no time is none.
#[derive(Default)]
struct Record(Vec<[f64; 2]>);

impl Motion for Record {
    fn drift(&mut self, dt: f64) {
        self.0.extend((dt != 0.0).then_some([0.0, dt]));
    }

    fn kick(&mut self, dt: f64) {
        self.0.extend((dt != 0.0).then_some([1.0, dt]));
    }
}

/// A simple one; then few and many drifts and kicks, back in time too, some for no time, no two alike.
pub(super) fn steps(random: &mut Random, ask: Ask<'_>) {
    let simple = Composition { drifts: vec![0.25, 0.5, 0.25], kicks: vec![0.375, 0.625] };
    let drawn = random.sizes(33).into_iter().flat_map(|kicks| [kicks; 8]).map(|kicks| {
        let mut fractions = |n: usize| -> Vec<f64> {
            let fraction = |_| match random.below(5) {
                0 => 0.0,
                _ => random.signed(1e-6, 1e3),
            };
            (0..n).map(fraction).collect()
        };
        let composition = Composition { drifts: fractions(kicks + 1), kicks: fractions(kicks) };
        (composition, random.magnitude(1e-12, 1e12))
    });
    for (composition, dt) in [(simple, 0.5)].into_iter().chain(drawn) {
        let mut record = Record::default();
        composition.step(&mut record, dt);
        let mut right = Vec::new();
        for (k, drift) in composition.drifts.iter().enumerate() {
            right.push([0.0, drift * dt]);
            right.extend(composition.kicks.get(k).map(|kick| [1.0, kick * dt]));
        }
        right.retain(|[_, time]| *time != 0.0);
        let near = |(k, &[what, time]): (usize, &[f64; 2])| {
            let right = right.get(k).map_or(0.0, |right| right[1]);
            [what, rounded(time, right, right.abs())]
        };
        let found = record.0.iter().enumerate().flat_map(near).collect();
        let question = format!(
            "a step of {dt:?}, {composition:?}: what is done one after the other, each as 0 for a drift or 1 for a kick \
             and then its time; nothing for no time"
        );
        ask(&question, found, right.concat());
    }
}

/// What pulls a particle: its own position, that of the next one, and something that is always there.
fn pulled(at: &[Vec2], pull: &[f64], i: usize) -> Vec2 {
    let next = at[(i + 1) % at.len()];
    pull[i] * (next - at[i]) + (0.5 * pull[i]) * Vec2::new(-at[i].y, 1.0)
}

/// None, few and many particles in a ring: the four positions where it looks, and the sum of the slopes.
pub(super) fn runge_kutta(random: &mut Random, ask: Ask<'_>) {
    for n in random.sizes(4097).into_iter().chain([70_000]) {
        let unit = random.magnitude(1e-9, 1e9);
        let h = random.magnitude(1e-9, 1e9);
        let mut vectors = |size: f64| -> Vec<Vec2> {
            (0..n)
                .map(|_| size * Vec2::new(random.signed(0.1, 1.0), random.signed(0.1, 1.0)))
                .collect()
        };
        let start = State { at: vectors(unit), v: vectors(unit / h) };
        let pull: Vec<f64> = (0..n).map(|_| random.signed(0.01, 1.0) / (h * h)).collect();
        let mut looks = Vec::new();
        let sum = slopes(&start, h, &mut |at, a| {
            looks.push(at.to_vec());
            a.iter_mut().enumerate().for_each(|(i, a)| *a = pulled(at, &pull, i));
        });
        let (mut right, mut right_looks) = (vec![[Vec2::ZERO; 2]; n], Vec::new());
        let mut stage = start.clone();
        for (weight, next) in [(1.0, 0.5), (2.0, 0.5), (2.0, 1.0), (1.0, 0.0)] {
            right_looks.push(stage.at.clone());
            let slope = State {
                at: stage.v.clone(),
                v: (0..n).map(|i| pulled(&stage.at, &pull, i)).collect(),
            };
            for (sum, (v, a)) in right.iter_mut().zip(slope.at.iter().zip(&slope.v)) {
                *sum = [sum[0] + weight * *v, sum[1] + weight * *a];
            }
            stage = start.along(&slope, next * h);
        }
        let name = format!("{n} particles in a ring, a step of {h:?}");
        ask(&format!("{name}: how often it looks"), vec![looks.len() as f64], vec![4.0]);
        let near = |found: &[Vec2], right: &[Vec2], scale: f64| -> Vec<f64> {
            let one = |(f, r): (&Vec2, &Vec2)| [rounded(f.x, r.x, scale), rounded(f.y, r.y, scale)];
            found.iter().zip(right).flat_map(one).collect()
        };
        let flat = |all: &[Vec2]| all.iter().flat_map(|v| [v.x, v.y]).collect::<Vec<f64>>();
        let mut tell = |what: &str, found: Vec<f64>, right: Vec<f64>| {
            if n <= 4097 {
                return ask(&format!("{name}: {what}"), found, right);
            }
            let wrong = found.iter().zip(&right).filter(|(found, right)| found != right).count();
            let wrong = wrong + found.len().abs_diff(right.len());
            ask(&format!("{name}: {what}: how many are wrong"), vec![wrong as f64], vec![0.0]);
        };
        for (k, (found, right)) in looks.iter().zip(&right_looks).enumerate() {
            let what = format!("where look {} is, x and y of each", k + 1);
            tell(&what, near(found, right, unit), flat(right));
        }
        let [v, a] = [0, 1].map(|k| right.iter().map(|sum| sum[k]).collect::<Vec<Vec2>>());
        tell("the sum of velocities", near(&sum.at, &v, unit / h), flat(&v));
        tell("sum of accelerations", near(&sum.v, &a, unit / (h * h)), flat(&a));
    }
}

/// Whoever looks so often does not end.
const WITHOUT_END: i32 = 10_000;

/// What falls by a line, steeply at first or at last, from zero itself, early and late, in any units of both.
pub(super) fn crossings(random: &mut Random, ask: Ask<'_>) {
    for case in 0..3000 {
        let stretch = if case % 7 == 0 { DT } else { random.magnitude(1e-12, 1e12) };
        let low = [0.0, stretch * random.magnitude(1e-3, 1e3)][random.below(2)];
        let high = low + stretch;
        let ends = [
            random.between(0.0, 1.0),
            random.magnitude(1e-6, 0.5),
            1.0 - random.magnitude(1e-6, 0.5),
        ];
        let share = if case % 5 > 1 { random.between(0.3, 0.99) } else { ends[random.below(3)] };
        let power = random.between(2.0, 9.0);
        let size = random.magnitude(1e-250, 1e250);
        // A part of the stretch, as it can be told from a time.
        let part = |t: f64| (t - low) / (high - low);
        let root = part(low + share * (high - low));
        let value = |t: f64| {
            let t = part(t);
            size * match case % 5 {
                0 => root - t,
                1 => (root + power - t).powi(2) - power * power,
                2 => root.powf(power) - t.powf(power),
                3 => (-power * t).exp() - (-power * root).exp(),
                _ => t * (root - t),
            }
        };
        if !(value(low) >= 0.0 && value(high) < 0.0) {
            continue;
        }
        let what = [
            "a line",
            "a parabola",
            "what falls late",
            "what falls early",
            "what rises from zero first",
        ];
        let name = format!(
            "{}, of size {size:e}, from {low:?} to {high:?}, falls {root:?} of the stretch into it",
            what[case % 5]
        );
        let (mut looks, mut outside) = (0, 0);
        let found = crossing(low, high, &mut |t| {
            looks += 1;
            assert!(looks < WITHOUT_END, "{name}: {looks} looks, and no end");
            outside += i32::from(!(low..=high).contains(&t));
            value(t)
        });
        let late = (part(found) - root) / 1e-12;
        let late = if late.abs() <= 3.0 { 0.0 } else { late };
        ask(
            &format!(
                "{name}: how late, in 10^-12 of the stretch, negative for too early; 0 for 3 or less"
            ),
            vec![late],
            vec![0.0],
        );
        let question = format!("{name}: is it at most 0 there?");
        ask(&question, vec![truth(value(found) <= 0.0)], vec![1.0]);
        ask(&format!("{name}: looks outside the stretch"), vec![f64::from(outside)], vec![0.0]);
        let looks = f64::from(looks.max(30));
        ask(&format!("{name}: looks, 30 for as many or fewer"), vec![looks], vec![30.0]);
    }
}

/// Lines so near to zero that a product of two numbers may be 0.
pub(super) fn faint_crossings(ask: Ask<'_>) {
    for (size, root) in
        [1e-300, 1e-308, 1e-315, 1e-320].into_iter().flat_map(|size| [(size, 0.25), (size, 0.75)])
    {
        let name =
            format!("a line of size {size:e}, from 0 to 1e-9, falls {root} of the stretch into it");
        let value = |t: f64| size * (root - t / 1e-9);
        let mut looks = 0;
        let found = crossing(0.0, 1e-9, &mut |t| {
            looks += 1;
            assert!(looks < WITHOUT_END, "{name}: {looks} looks, and no end");
            value(t)
        });
        ask(
            &format!("{name}: is it at most 0 there?"),
            vec![truth(value(found) <= 0.0)],
            vec![1.0],
        );
        // The smallest number that is not 0 is 5e-324.
        let late = found / 1e-9 - root > 3e-12 + 1e-323 / size;
        ask(&format!("{name}: is it later than its digits tell?"), vec![truth(late)], vec![0.0]);
    }
}

/// Lines and parabolas that fall, dip, come near, rise first, or have just been through an event, in any units. Every
/// other time they are bent, so that no parabola goes through them.
pub(super) fn falls(random: &mut Random, ask: Ask<'_>) {
    for case in 0..4000 {
        let (h, size) = (random.magnitude(1e-12, 1e12), random.magnitude(1e-100, 1e100));
        let s = random.between(0.05, 0.95);
        let (a, b) = (s * random.between(0.1, 0.9), s);
        let gap = random.magnitude(1e-9, 0.5);
        let (dip, late) = (s * random.magnitude(1e-3, 0.5), random.magnitude(1e-17, 1e-13));
        // The three numbers of a parabola, in parts of the step, and when it falls.
        let kinds: [(&str, [f64; 3], Option<f64>); 23] = [
            ("falls", [s, -1.0, 0.0], Some(s)),
            ("falls, not far enough", [1.0 + gap, -1.0, 0.0], None),
            ("rises", [gap, s, 0.0], None),
            ("dips below zero and comes back", [a * b, -a - b, 1.0], Some(a)),
            ("dips a little", [s * s - dip * dip, -2.0 * s, 1.0], Some(s - dip)),
            ("comes near zero and goes away", [s * s + gap, -2.0 * s, 1.0], None),
            ("rises and then falls", [b * a, b - a, -1.0], Some(b)),
            ("rises and then falls, not far enough", [gap, 1.0, -1.0], None),
            ("is at zero and leaves", [0.0, s, 0.0], None),
            ("is at zero, leaves and comes back", [0.0, s, -1.0], Some(s)),
            ("has been seen a little too late and leaves", [-late, s, 0.0], None),
            (
                "has been seen a little too late, leaves and comes back",
                [-late * s, s, -1.0],
                Some(s),
            ),
            (
                "has been seen late, leaves and comes back",
                [-(s - dip) * dip, s, -1.0],
                Some(s - dip),
            ),
            ("rises to zero and no higher", [-0.25, 1.0, -1.0], Some(0.5)),
            ("has been seen a little too late and goes on", [-late, -s, 0.0], Some(0.0)),
            ("is at zero and falls", [0.0, -s, 1.0], Some(0.0)),
            ("rises all the way, still below zero", [-1.0 - gap, 1.0, 0.0], None),
            ("starts level and falls", [s * s, 0.0, -1.0], Some(s)),
            ("is level at zero and falls", [0.0, 0.0, -s], Some(0.0)),
            ("is level at zero and rises", [0.0, 0.0, s], None),
            ("falls and ends level, below zero", [1.0 - s * s, -2.0, 1.0], Some(1.0 - s)),
            ("never gets above zero", [-gap - s * s, 2.0 * s, -1.0], Some(s)),
            ("stays above zero by a hair", [1e-9 + gap, -1e-12, 0.0], None),
        ];
        let (what, [c, d, e], right) = kinds[case % 23];
        // Earlier by a bend, except at both ends.
        let bend = [0.0, random.between(0.1, 2.0)][case / 23 % 2];
        let right = right.map(|t| t / (1.0 + bend - bend * t));
        let watch = |t: f64| {
            let t = t / h;
            let faster = (1.0 + bend) / (1.0 + bend * t);
            let s = faster * t;
            let slope = (d + 2.0 * s * e) * faster / (1.0 + bend * t);
            Watched { value: size * (c + s * (d + s * e)), slope: size * (slope / h) }
        };
        let name = format!(
            "what {what}, {c:?} + {d:?} s + {e:?} s², s = (1 + b) t / (1 + b t), b = {bend:?}, of size {size:e}, in a \
             step of {h:?}"
        );
        let (mut looks, mut outside) = (0, 0);
        let found = first_fall(watch(0.0), watch(h), h, &mut |t| {
            looks += 1;
            assert!(looks < WITHOUT_END, "{name}: {looks} looks, and no end");
            outside += i32::from(!(0.0..=h).contains(&t));
            watch(t)
        });
        let near = |found: f64| {
            // What begins with a fall falls at 0 itself.
            let right = right.filter(|right| *right > 0.0 || d == 0.0);
            right.map_or(found, |right| if (found - right).abs() <= 1e-11 { right } else { found })
        };
        let found = found.map(|found| near(found / h)).into_iter().collect();
        ask(
            &format!("{name}: when it falls, in steps, nothing if it does not"),
            found,
            right.into_iter().collect(),
        );
        ask(&format!("{name}: looks outside the step"), vec![f64::from(outside)], vec![0.0]);
        let many = f64::from((looks - 100).max(0));
        ask(&format!("{name}: looks beyond 100"), vec![many], vec![0.0]);
        if what == "falls, not far enough" {
            ask(&format!("{name}: looks at its ends"), vec![f64::from(looks)], vec![0.0]);
        }
    }
    let at = |t: f64| Watched { value: (t - 1.0) * (t - 1.0), slope: 2.0 * (t - 1.0) };
    let found = first_fall(at(0.0), at(2.0), 2.0, &mut |t| at(t));
    ask("(t - 1)² in a step of 2 touches 0: when it falls", found.into_iter().collect(), vec![]);
}
