//! Compares the greedy rule of hard discs, at most one collision per disc and step, with the exact
//! motion.
//!
//! The rule takes the earliest collision of each disc. For the rest of the step the disc flies
//! through every disc that it would have met next. The shorter the step, the rarer are such discs.
//! The exact motion, collision by collision, shows how much the rule loses.

use std::env;
use std::f64::consts::PI;
use std::fs;
use std::io;

use common::hard::Disc;
use oracle::Random;
use oracle::hard::{Exact, step};
use serde_json::json;

/// Share of the square that the discs cover.
const FRACTION: f64 = 0.1;
/// Number of scenes in an average.
const SCENES: u64 = 20;

/// Number of discs along a side of the lattice at the start.
const ALONG: u32 = 10;
/// Side of the square.
const SIDE: f64 = 100.0;
/// Total time of a run.
const TIME: f64 = 16.0;

/// Greatest velocity component.
const SPEED: f64 = 2.0;

const COMMAND: &str = "cargo run --release -p hard-discs --example greedy --";

/// The loss with steps of one length, averaged over the scenes.
struct Loss {
    /// Mean distance that a disc flies in a step, in radii.
    way: f64,
    /// Number of collisions under the rule.
    collisions: f64,
    /// Number of collisions of the exact motion.
    exact: f64,
    /// Mean distance between the end of a disc and its exact end, in radii.
    error: f64,
}

/// Prints a table, and writes its numbers to the file that the command line names.
fn main() -> io::Result<()> {
    let n = ALONG * ALONG;
    let radius = (FRACTION * SIDE * SIDE / (f64::from(n) * PI)).sqrt();
    println!("{n} discs of radius {radius:.3} in a square of side {SIDE}, until time {TIME}\n");
    println!("steps  way / r  collisions  of exact  error / r");
    let mut losses = Vec::new();
    for steps in (0..=10).map(|doubled| 1_u32 << doubled) {
        let Loss { way, collisions, exact, error } = Loss::of(radius, steps);
        let share = 100.0 * collisions / exact;
        println!("{steps:5}  {way:7.3}  {collisions:10.1}  {share:6.1} %  {error:9.5}");
        losses.push(json!({
            "steps": steps,
            "way_in_radii": way,
            "collisions": collisions,
            "exact_collisions": exact,
            "error_in_radii": error,
        }));
    }
    let Some(file) = env::args().nth(1) else { return Ok(()) };
    let numbers = json!({
        "command": format!("{COMMAND} {file}"),
        "results": { "fraction": FRACTION, "scenes": SCENES, "steps": losses },
    });
    fs::write(file, format!("{numbers:#}\n"))
}

impl Loss {
    /// Runs all scenes in `steps` steps.
    fn of(radius: f64, steps: u32) -> Self {
        let (mut taken, mut exact, mut error) = (0, 0, 0.0);
        for seed in 0..SCENES {
            let start = start(radius, seed);
            let mut truth = Exact::new(&start, SIDE, radius);
            let end = truth.run_until(TIME);
            exact += truth.collisions();
            let found = greedy(&start, radius, steps, &mut taken);
            let pairs = found.iter().zip(&end);
            let off = pairs.map(|(a, b)| (a.position() - b.position()).norm_squared().sqrt());
            error += off.sum::<f64>() / start.len() as f64;
        }
        let scenes = SCENES as f64;
        Self {
            // This is the mean magnitude of a velocity whose components are uniform in −SPEED …
            // SPEED.
            way: 0.765 * SPEED * TIME / f64::from(steps) / radius,
            collisions: taken as f64 / scenes,
            exact: exact as f64 / scenes,
            error: error / scenes / radius,
        }
    }
}

/// Makes discs with random velocities on a lattice, so that no discs overlap.
fn start(radius: f64, seed: u64) -> Vec<Disc> {
    let mut random = Random::new(seed);
    let wide = SIDE - 2.0 * radius;
    let mut discs = Vec::new();
    for k in 0..ALONG * ALONG {
        let shares = [k % ALONG, k / ALONG].map(|at| wide * f64::from(at) / f64::from(ALONG - 1));
        let [x, y] = shares.map(|share| radius + share);
        let vx = random.between(-SPEED, SPEED);
        discs.push(Disc::new(x, y, vx, random.between(-SPEED, SPEED)));
    }
    discs
}

/// Moves the discs according to the rule, adds its collisions to `taken`, and returns the discs at
/// the end.
///
/// A step of the rule has length 1, so velocities are scaled.
fn greedy(start: &[Disc], radius: f64, steps: u32, taken: &mut u64) -> Vec<Disc> {
    let length = TIME / f64::from(steps);
    let mut discs: Vec<_> =
        start.iter().map(|d| Disc::new(d.x, d.y, length * d.vx, length * d.vy)).collect();
    for _ in 0..steps {
        let (next, events) = step(&discs, SIDE, radius);
        *taken += events.len() as u64;
        discs = next;
    }
    discs
}
