//! The worked examples: a scene that can be checked by hand, and the lab's results.

use common::Vec2;
use common::soft::{CUTOFF, Observer, Particle, Scene, Simulation};
use lab1::{
    AllPairs, Tally, advance, bounce, kinetic_energy, momentum, pair_acceleration, pair_potential,
    potential_energy,
};
use oracle::{Ask, Count, Random, Table};

/// Returns a distance vector of length `r` cutoffs that is not parallel to an axis.
fn distance(r: f64) -> Vec2 {
    r * CUTOFF * Vec2::new(0.6, 0.8)
}

/// Returns a particle at (x, y) cutoffs.
fn at(x: f64, y: f64, vx: f64, vy: f64) -> Particle {
    Particle { x: x * CUTOFF, y: y * CUTOFF, vx, vy, id: 0 }
}

pub(crate) fn force_table(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let mut table = Table::new(["r / cutoff", "ax", "ay"]);
        let number = |a: f64| format!("{:.6e}", a + 0.0);
        for r in [0.0, 0.003, 0.01, 0.1, 0.5, 0.9, 0.9995, 1.0005, 2.0] {
            match pair_acceleration(distance(r)) {
                // Negative zero becomes zero.
                Some(a) => table.row([&r, &number(a.x), &number(a.y)]),
                None => table.row([&r, &"none", &"none"]),
            }
        }
        table.to_string()
    });
}

pub(crate) fn bounce_table(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let mut table = Table::new(["x", "v", "ends at x", "with v", ""]);
        for (x, v, what) in [
            (0.25, 2.0, "inside"),
            (0.0, -2.0, "on a wall, which is inside"),
            (1.0, 2.0, "on the other wall"),
            (-0.25, -2.0, "beyond the left wall"),
            (1.25, 2.0, "beyond the right wall"),
            (2.25, 4.0, "beyond it by more than a box: two reflections"),
            (-2.5, -6.0, "three reflections"),
        ] {
            let (end, after) = bounce(x, v, 1.0);
            table.row([&x, &v, &(end + 0.0), &after, &what]);
        }
        table.to_string()
    });
}

pub(crate) fn velocity_first(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let mut table = Table::new(["ax", "ay", "vx", "vy", "x", "y", ""]);
        let mut particle = Particle { x: 0.5, y: 0.5, vx: 1.0, vy: -2.0, id: 0 };
        let mut row = |a: Vec2, p: &Particle, what: &str| {
            table.row([&a.x, &a.y, &p.vx, &p.vy, &p.x, &p.y, &what]);
        };
        row(Vec2::ZERO, &particle, "at first");
        for a in [Vec2::new(400.0, 0.0), Vec2::new(0.0, -200.0)] {
            advance(&mut particle, a, 1.0);
            row(a, &particle, "after a step of 0.0005");
        }
        table.to_string()
    });
}

pub(crate) fn step_table(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let particles =
            vec![at(2.0, 5.0, 0.0, 0.0), at(2.5, 5.0, 0.0, 1.0), at(8.0, 8.0, 1.0, -1.0)];
        let scene = Scene::new(10.0 * CUTOFF, particles).expect("all particles are in the box");
        let mut engine = AllPairs::<Count>::default();
        engine.load(&scene);
        engine.step();
        let mut after = scene.particles().to_vec();
        engine.read(0, &mut after);
        let mut table = Table::new(["particle", "", "x / cutoff", "y / cutoff", "vx", "vy"]);
        for (before, after) in scene.particles().iter().zip(&after) {
            for (when, p) in [("before", before), ("after", after)] {
                let cutoffs = |x: f64| format!("{:.4}", x / CUTOFF);
                let speed = |v: f64| format!("{:.3}", v + 0.0);
                table.row([&p.id, &when, &cutoffs(p.x), &cutoffs(p.y), &speed(p.vx), &speed(p.vy)]);
            }
        }
        table.to_string()
    });
}

pub(crate) fn tally_table(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let mut table = Table::new(["r / cutoff", "dmin", "davg", "navg"]);
        let mut tally = Tally::default();
        let mut row = |r: &str, tally: &Tally| {
            let seen = tally.statistics().expect("a tally returns statistics");
            let [dmin, davg] = [seen.dmin, seen.davg].map(|distance| format!("{distance:.2}"));
            table.row([&r, &dmin, &davg, &seen.navg]);
        };
        row("nothing yet", &tally);
        for r in [0.75, 0.5, 0.5, 0.0, 1.0, 0.25] {
            tally.seen((r * CUTOFF) * (r * CUTOFF));
            row(&r.to_string(), &tally);
        }
        table.to_string()
    });
}

pub(crate) fn energy_table(_: &mut Random, ask: &mut impl Ask) {
    ask.example(|| {
        let mut table = Table::new(["", "value"]);
        let number = |value: f64| format!("{value:.6}");
        for r in [2.0, 1.0, 0.5, 0.01, 0.0] {
            let potential = pair_potential(distance(r));
            table.row([&format!("potential of a pair, r = {r} cutoffs"), &number(potential)]);
        }
        // The mass of a particle is 0.01.
        let particles = [at(1.0, 1.0, 2.0, 0.0), at(1.5, 1.0, 0.0, -4.0), at(5.0, 5.0, 1.0, 1.0)];
        table.row([&"three particles: potential energy", &number(potential_energy(&particles))]);
        table.row([&"three particles: energy of motion", &number(kinetic_energy(&particles))]);
        let momentum = momentum(&particles);
        table.row([&"three particles: momentum along x", &number(momentum.x)]);
        table.row([&"three particles: momentum along y", &number(momentum.y)]);
        table.to_string()
    });
}
