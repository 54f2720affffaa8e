//! The greedy rule of hard discs against the exact motion: how much is lost because a disc collides once in a step.
//!
//! The rule takes the earliest collision of each disc and lets the disc fly on for the rest of the step, through every
//! disc that it would have met next. The shorter the step, the rarer that is. The exact motion, collision by collision,
//! tells how much is lost.

use std::f64::consts::PI;
use std::process::ExitCode;

use anyhow::Result;
use clap::Parser;
use common::hard::Disc;
use lab_measure::columns::Columns;
use lab_measure::numbers::Json;
use oracle::Random;
use oracle::hard::{Exact, step};
use serde::Serialize;

/// Measure the greedy rule of the hard discs against the exact motion
#[derive(Parser)]
#[command(name = "greedy")]
struct Options {
    #[command(flatten)]
    json: Json,
}

/// Losses with steps of one length, averaged over the scenes.
#[derive(Serialize)]
struct Loss {
    steps: u32,
    /// Mean distance that a disc flies in a step, in radii.
    way_in_radii: f64,
    /// Collisions by the rule.
    collisions: f64,
    /// Collisions of the exact motion.
    exact_collisions: f64,
    /// Mean distance between the end of a disc and its exact end, in radii.
    error_in_radii: f64,
}

#[derive(Serialize)]
struct Results {
    fraction: f64,
    scenes: u64,
    steps: Vec<Loss>,
}

/// Part of the square that the discs cover, and scenes to average over.
const FRACTION: f64 = 0.1;
const SCENES: u64 = 20;

/// Discs along a side of the start's lattice, its side, and the time that passes.
const ALONG: u32 = 10;
const SIDE: f64 = 100.0;
const TIME: f64 = 16.0;

/// Greatest velocity component.
const SPEED: f64 = 2.0;

fn main() -> ExitCode {
    lab_kit::command::finish(run(&Options::parse()))
}

fn run(options: &Options) -> Result<ExitCode> {
    let n = ALONG * ALONG;
    let radius = (FRACTION * SIDE * SIDE / (f64::from(n) * PI)).sqrt();
    println!("{n} discs of radius {radius:.3} in a square of side {SIDE}, until time {TIME}");
    let steps: Vec<Loss> = (0..=10).map(|doubled| Loss::of(radius, 1 << doubled)).collect();
    let table = Columns::of("steps", |loss: &Loss| loss.steps.to_string())
        .text("way / r", |loss| format!("{:.3}", loss.way_in_radii))
        .text("collisions", |loss| format!("{:.1}", loss.collisions))
        .text("of exact", |loss| {
            format!("{:.1} %", 100.0 * loss.collisions / loss.exact_collisions)
        })
        .text("error / r", |loss| format!("{:.5}", loss.error_in_radii))
        .table(&steps);
    println!("{table}");
    let results = Results { fraction: FRACTION, scenes: SCENES, steps };
    options.json.write_by("cargo run --release -p hard-discs --example greedy --", results)?;
    Ok(ExitCode::SUCCESS)
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
            steps,
            // The mean magnitude of a velocity whose components are uniform in −SPEED … SPEED.
            way_in_radii: 0.765 * SPEED * TIME / f64::from(steps) / radius,
            collisions: taken as f64 / scenes,
            exact_collisions: exact as f64 / scenes,
            error_in_radii: error / scenes / radius,
        }
    }
}

/// Makes discs on a lattice, so that none overlap, with random velocities.
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

/// Moves the discs by the rule, adds its collisions to `taken`, and returns where the discs end. A step of the rule has
/// length 1, so velocities are scaled.
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
