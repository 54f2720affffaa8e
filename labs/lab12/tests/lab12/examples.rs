//! The worked examples: cases that can be checked by hand, and the lab's results.

use common::Vec2;
use common::soft::{CUTOFF, DT, MASS};
use integrators::{State, Watched};
use lab12::{Composition, Motion, crossing, first_fall, slopes};
use oracle::{Ask, Random, Table};

use super::farthest;
use super::whole_runs::{end_of, in_contact};

/// A system that records drifts and kicks, and their sums so far.
struct Diary {
    table: Table,
    composition: &'static str,
    drifted: f64,
    kicked: f64,
}

impl Diary {
    fn write(&mut self, what: &str, dt: f64) {
        if dt == 0.0 {
            return;
        }
        let [dt, at, v] = [dt, self.drifted, self.kicked].map(|time| format!("{time:.6}"));
        self.table.row([&self.composition, &what, &dt, &at, &v]);
        self.composition = "";
    }
}

impl Motion for Diary {
    fn drift(&mut self, dt: f64) {
        self.drifted += dt;
        self.write("drift", dt);
    }

    fn kick(&mut self, dt: f64) {
        self.kicked += dt;
        self.write("kick", dt);
    }
}

pub(crate) fn drifts_and_kicks(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let table = Table::new(["composition", "what", "for", "positions at", "velocities at"]);
        let mut diary = Diary { table, composition: "", drifted: 0.0, kicked: 0.0 };
        for (name, composition) in [
            ("official step", Composition::symplectic_euler as fn() -> Composition),
            ("velocity Verlet", Composition::velocity_verlet),
            ("PEFRL", Composition::pefrl),
        ] {
            diary = Diary { composition: name, drifted: 0.0, kicked: 0.0, ..diary };
            composition().step(&mut diary, 1.0);
        }
        diary.table.to_string()
    });
}

pub(crate) fn four_looks(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let mut table = Table::new(["", "x of A", "ax of A", "x of B", "ax of B"]);
        let [at, v] = [[1.0, 0.0], [0.0, 2.0]].map(|x| x.map(|x| Vec2::new(x, 0.0)).to_vec());
        let start = State { at, v };
        let mut look = 0;
        let sum = slopes(&start, 1.0, &mut |at, a| {
            a.iter_mut().zip(at).for_each(|(a, &at)| *a = -at);
            look += 1;
            let [x_a, a_a, x_b, a_b] = [at[0].x, a[0].x, at[1].x, a[1].x].map(|x| x + 0.0);
            table.row([&format!("look {look}"), &x_a, &a_a, &x_b, &a_b]);
        });
        let line = |k: usize| format!("{} and {}", sum.at[k].x + 0.0, sum.v[k].x + 0.0);
        format!("{table}\nweighted sum of vx and of ax: {} for A, {} for B\n", line(0), line(1))
    });
}

pub(crate) fn errors(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let scene = in_contact();
        // Calls task 12.2 first, so that an unsolved starter stops at the `todo!` of task 12.2.
        let finest = end_of("rk4", 256.0, &scene, 1);
        let mut table = Table::new(["error in cutoffs", "2 parts", "4 parts", "8 parts", "order"]);
        for variant in ["euler", "velocity-verlet", "pefrl", "rk4"] {
            let error = |parts| farthest(&end_of(variant, parts, &scene, 1), &finest) / CUTOFF;
            let errors = [2.0, 4.0, 8.0].map(error);
            let [two, four, eight] = errors.map(|error| format!("{error:.0e}"));
            let order = format!("{:.1}", (errors[1] / errors[2]).log2());
            table.row([&variant, &two, &four, &eight, &order]);
        }
        table.to_string()
    });
}

pub(crate) fn falling_numbers(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let mut table = Table::new(["number", "low", "high", "falls through zero at"]);
        for (name, low, high, value) in [
            ("0.75 - t", 0.0, 1.0, (|t| 0.75 - t) as fn(f64) -> f64),
            ("2 - t²", 1.0, 2.0, |t| 2.0 - t * t),
            ("1 - t⁹", 0.0, 4.0, |t| 1.0 - t.powi(9)),
            ("t (0.5 - t)", 0.0, 1.0, |t| t * (0.5 - t)),
            ("1 / t - 8", 0.0625, 1.0, |t| 1.0 / t - 8.0),
        ] {
            let moment = crossing(low, high, &mut |t| value(t));
            table.row([&name, &low, &high, &format!("{moment:.6}")]);
        }
        table.to_string()
    });
}

/// Two particles that collide head-on, from the moment at which they come within reach.
struct HeadOn {
    /// Initial relative speed.
    speed: f64,
}

/// The distance of two particles, and its rate of growth.
struct Gap {
    distance: f64,
    growth: f64,
}

impl HeadOn {
    /// Returns the gap after a time `t`, computed with many short steps.
    fn after(&self, t: f64) -> Gap {
        let steps = 10_000;
        let dt = t / f64::from(steps);
        let mut gap = Gap { distance: CUTOFF, growth: -self.speed };
        for _ in 0..steps {
            gap.distance += 0.5 * dt * gap.growth;
            let r = gap.distance;
            // Both particles are pushed.
            gap.growth += if r < CUTOFF { 2.0 * dt * (CUTOFF / r - 1.0) / (r * MASS) } else { 0.0 };
            gap.distance += 0.5 * dt * gap.growth;
        }
        gap
    }
}

pub(crate) fn contacts(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let headings = ["relative speed", "contact, in steps", "least distance, in cutoffs"];
        let mut table = Table::new(headings);
        for speed in [0.01, 0.1, 1.0, 2.83, 5.0, 10.0, 20.0] {
            let pair = HeadOn { speed };
            let [early, late] = [0.1 * DT, 5.0 * DT];
            let parted = crossing(early, late, &mut |t| CUTOFF - pair.after(t).distance);
            let turned = crossing(early, late, &mut |t| -pair.after(t).growth);
            let least = pair.after(turned).distance / CUTOFF;
            table.row([&speed, &format!("{:.2}", parted / DT), &format!("{least:.3}")]);
        }
        table.to_string()
    });
}

pub(crate) fn watched_numbers(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let headings = ["number", "value, slope at 0", "value, slope at 1", "falls at", ""];
        let mut table = Table::new(headings);
        for (name, [c, d, e], what) in [
            ("0.5 - t", [0.5, -1.0, 0.0], "falls"),
            ("2 - t", [2.0, -1.0, 0.0], "falls, not far enough"),
            ("0.1875 - t + t²", [0.1875, -1.0, 1.0], "dips below zero and comes back"),
            ("0.5 - t + t²", [0.5, -1.0, 1.0], "comes near zero and goes away"),
            ("0.1875 + 0.5 t - t²", [0.1875, 0.5, -1.0], "rises, then falls"),
            ("-t", [0.0, -1.0, 0.0], "is at zero and falls"),
            ("0.5 t - t²", [0.0, 0.5, -1.0], "is at zero, rises, then falls"),
            ("-1 + t - t²", [-1.0, 1.0, -1.0], "never gets above zero: the top counts"),
            ("-2 + t", [-2.0, 1.0, 0.0], "rises all the way"),
        ] {
            let watch = |t: f64| Watched { value: c + t * (d + t * e), slope: d + 2.0 * t * e };
            let [start, end] = [0.0, 1.0].map(watch);
            let fall = first_fall(start, end, 1.0, &mut |t| watch(t));
            let fall = fall.map_or("never".into(), |t| format!("{:.6}", t + 0.0));
            let [start, end] = [start, end].map(shown);
            table.row([&name, &start, &end, &fall, &what]);
        }
        table.to_string()
    });
}

/// Formats value and slope. Negative zero becomes zero.
fn shown(at: Watched) -> String {
    format!("{}, {}", at.value + 0.0, at.slope + 0.0)
}
