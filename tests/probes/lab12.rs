//! What is asked about lab 12: each task's own functions. Whole engines need several of them.

use common::Vec2;
use common::soft::DT;
use integrators::{State, Watched};
use lab12::{Composition, Motion, crossing, first_fall, slopes};

use crate::{Answers, Random, truth};

/// Asks everything about a task.
pub fn ask(task: &str, random: &mut Random, answers: &mut Answers) {
    match task {
        "12.1" => {
            steps(random, answers);
            compositions(answers);
        }
        "12.2" => runge_kutta(random, answers),
        "12.3" => crossings(random, answers),
        "12.4" => falls(random, answers),
        _ => panic!("there is no task {task}"),
    }
}

/// A pendulum that writes down where it was when it was kicked.
struct Pendulum {
    x: f64,
    v: f64,
    seen: Vec<f64>,
}

impl Motion for Pendulum {
    fn drift(&mut self, dt: f64) {
        self.x += self.v * dt;
    }

    fn kick(&mut self, dt: f64) {
        self.v -= self.x * dt;
        self.seen.extend([self.x, self.v]);
    }
}

fn steps(random: &mut Random, answers: &mut Answers) {
    for case in 0..100 {
        let mut fractions = |n: usize| (0..n).map(|_| random.between(-0.5, 1.0)).collect();
        let kicks = case % 7;
        let composition = Composition { drifts: fractions(kicks + 1), kicks: fractions(kicks) };
        let mut pendulum = Pendulum { x: 1.0, v: 0.5, seen: Vec::new() };
        composition.step(&mut pendulum, 0.25);
        let Pendulum { x, v, mut seen } = pendulum;
        seen.extend([x, v]);
        let question =
            format!("case {case}: a pendulum at each kick and at the end, {composition:?}");
        answers.close(&question, &seen);
    }
}

fn compositions(answers: &mut Answers) {
    for (name, composition) in
        [("velocity Verlet", Composition::velocity_verlet()), ("PEFRL", Composition::pefrl())]
    {
        answers.close(&format!("the drifts of {name}"), &composition.drifts);
        answers.close(&format!("the kicks of {name}"), &composition.kicks);
    }
}

fn runge_kutta(random: &mut Random, answers: &mut Answers) {
    for case in 0..100 {
        let mut vectors = |n: usize| -> Vec<Vec2> {
            (0..n)
                .map(|_| Vec2::new(random.between(-1.0, 1.0), random.between(-1.0, 1.0)))
                .collect()
        };
        let n = 1 + case % 6;
        let start = State { at: vectors(n), v: vectors(n) };
        let h = random.between(0.01, 0.5);
        let mut looks = 0;
        // A ring of particles, each pulled to the next one.
        let sum = slopes(&start, h, &mut |at, a| {
            looks += 1;
            for i in 0..at.len() {
                let d = at[(i + 1) % at.len()] - at[i];
                a[i] = (1.0 + d.norm_squared()) * d - at[i];
            }
        });
        let values: Vec<f64> = sum.at.iter().chain(&sum.v).flat_map(|s| [s.x, s.y]).collect();
        let question = format!("case {case}: the sum of the slopes of {n} particles for {h}");
        answers.close(&question, &values);
        let question = format!("case {case}: how often it asks for accelerations");
        answers.exact(&question, &[f64::from(looks)]);
    }
}

/// Walls ahead, pairs that come near, and what falls early or late: numbers of a known root.
fn crossings(random: &mut Random, answers: &mut Answers) {
    for case in 0..300 {
        let low = random.between(0.0, 3.0) * DT;
        let high = low + DT;
        let root = random.between(0.3, 0.95);
        let power = random.between(2.0, 5.0);
        let value = |t: f64| match case % 4 {
            0 => root - t,
            1 => (root + power - t).powi(2) - power * power,
            2 => root.powf(power) - t.powf(power),
            _ => (-power * t).exp() - (-power * root).exp(),
        };
        let mut looks = 0;
        let found = crossing(low, high, &mut |t| {
            looks += 1;
            value((t - low) / DT)
        });
        let what = ["a wall", "a pair", "one that falls late", "one that falls early"][case % 4];
        let question = format!("case {case}, {what}, from {low} for a step, falls {root} into it");
        answers.close(&question, &[(found - low) / DT]);
        let question = format!("{question}: whether more than 30 looks were needed");
        answers.exact(&question, &[truth(looks > 30)]);
    }
}

/// Parabolas: lines, dips, near misses, tops above and below zero, and what begins at zero.
fn falls(random: &mut Random, answers: &mut Answers) {
    for case in 0..400 {
        let h = random.between(0.5, 2.0) * DT;
        let vertex = random.between(0.1, 0.9);
        let height = random.between(0.01, 0.2) * [1.0, -1.0][case % 2];
        let bend = [1.0, -1.0][case / 2 % 2] * random.between(0.5, 2.0);
        let slope = random.between(0.5, 2.0) * [1.0, -1.0][case / 4 % 2];
        let watch = |t: f64| {
            let t = t / h;
            let (value, slope) = match case % 5 {
                // From zero on: it has just been through an event.
                0 => (t * (slope + bend * t), slope + 2.0 * bend * t),
                1 => (height + slope * (t - vertex), slope),
                _ => (height + bend * (t - vertex).powi(2), 2.0 * bend * (t - vertex)),
            };
            Watched { value, slope: slope / h }
        };
        let found = first_fall(watch(0.0), watch(h), h, &mut |t| watch(t));
        let question = format!(
            "case {case}: when what begins as {:?} and ends as {:?} falls within {h}, in steps, or -1",
            watch(0.0),
            watch(h)
        );
        answers.close(&question, &[found.map_or(-1.0, |time| time / h)]);
    }
}
