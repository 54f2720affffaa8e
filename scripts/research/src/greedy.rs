//! `cargo lab greedy`: how wrong the hard discs' rule is that a disc collides once in a step.
//!
//! The model takes the earliest collision of each disc and lets it fly on for the rest of the step,
//! through whatever it would have met next. The shorter the step, the rarer that is. The exact
//! motion, collision by collision, tells how much is lost.

use std::f64::consts::PI;
use std::process::ExitCode;

use anyhow::Result;
use clap::Args;
use common::hard::Disc;
use oracle::Random;
use oracle::hard::{Exact, step};
use serde::{Deserialize, Serialize};

use lab_kit::table::Table;
use lab_measure::chart::{Axis, Chart, Kind, Series, Sheet};
use lab_measure::columns::Columns;
use lab_measure::files::Files;

/// Measure the greedy rule of the hard discs against the exact motion
#[derive(Args)]
pub(crate) struct Options {
    #[command(flatten)]
    pub(crate) files: Files,
}

/// What is lost with steps of one length, on average over the scenes.
#[derive(Deserialize, Serialize)]
struct Loss {
    steps: u32,
    /// The mean way of a disc in a step, in radii.
    #[serde(rename = "way_in_radii")]
    way: f64,
    /// Collisions of the model.
    collisions: f64,
    /// Collisions of the exact motion.
    #[serde(rename = "exact_collisions")]
    exact: f64,
    /// The mean distance between where a disc ends and where it should, in radii.
    #[serde(rename = "error_in_radii")]
    error: f64,
}

#[derive(Deserialize, Serialize)]
pub(crate) struct Results {
    fraction: f64,
    scenes: u64,
    steps: Vec<Loss>,
}

impl Options {
    pub(crate) fn draw(&self, results: Results) -> Result<Sheet> {
        Ok(vec![charts(&results.steps).into()])
    }
}

/// Part of the square that the discs cover, and scenes to average over.
const FRACTION: f64 = 0.1;
const SCENES: u64 = 20;

/// Discs along a side of the start's lattice, its side, and the time that passes.
const ALONG: u32 = 10;
const SIDE: f64 = 100.0;
const TIME: f64 = 16.0;

/// The greatest velocity component.
const SPEED: f64 = 2.0;

pub(crate) fn run(options: &Options) -> Result<ExitCode> {
    let n = ALONG * ALONG;
    let radius = (FRACTION * SIDE * SIDE / (f64::from(n) * PI)).sqrt();
    println!("{n} discs of radius {radius:.3} in a square of side {SIDE}, until time {TIME}");
    let steps = (0..=10).map(|doubling| 1_u32 << doubling);
    let losses: Vec<Loss> = steps.map(|steps| loss(radius, steps)).collect();
    println!("{}", table(&losses));
    let results = Results { fraction: FRACTION, scenes: SCENES, steps: losses };
    options.files.write(results, |shown| options.draw(shown))?;
    Ok(ExitCode::SUCCESS)
}

/// Runs all scenes in `steps` steps.
fn loss(radius: f64, steps: u32) -> Loss {
    let (mut taken, mut exact, mut error) = (0, 0, 0.0);
    for seed in 0..SCENES {
        let start = start(radius, seed);
        let mut truth = Exact::new(&start, SIDE, radius);
        let end = truth.run_until(TIME);
        let (found, collisions) = greedy(&start, radius, steps);
        taken += collisions;
        exact += truth.collisions();
        let off = |(a, b): (&Disc, &Disc)| (a.position() - b.position()).norm_squared().sqrt();
        error += found.iter().zip(&end).map(off).sum::<f64>() / start.len() as f64;
    }
    let scenes = SCENES as f64;
    Loss {
        steps,
        // The mean magnitude of a velocity whose components are even in −SPEED … SPEED.
        way: 0.765 * SPEED * TIME / f64::from(steps) / radius,
        collisions: taken as f64 / scenes,
        exact: exact as f64 / scenes,
        error: error / scenes / radius,
    }
}

impl Loss {
    fn share(&self) -> f64 {
        100.0 * self.collisions / self.exact
    }
}

fn table(losses: &[Loss]) -> Table {
    Columns::of("steps", |loss: &Loss| loss.steps.to_string())
        .text("way / r", |loss| format!("{:.3}", loss.way))
        .text("collisions", |loss| format!("{:.1}", loss.collisions))
        .text("of exact", |loss| format!("{:.1} %", loss.share()))
        .text("error / r", |loss| format!("{:.5}", loss.error))
        .table(losses)
}

fn charts(losses: &[Loss]) -> [Chart; 2] {
    let points = |y: fn(&Loss) -> f64| losses.iter().map(|loss| (loss.way, y(loss))).collect();
    let way = || Axis::log("distance in a step / r");
    let error = Chart::new(
        "How far off the discs end, against the step",
        way(),
        Axis::log("mean error of positions / r"),
    )
    .with(Series::new(
        Kind::Measured,
        "one collision a step, the earliest",
        points(|loss| loss.error),
    ));
    let kept = Chart::new(
        "How many collisions are kept",
        way(),
        Axis::linear("collisions kept [%]").starting_at(0.0),
    )
    .with(Series::new(
        Kind::Measured,
        "one collision a step, the earliest",
        points(Loss::share),
    ));
    [error, kept]
}

/// Discs on a lattice, so that none overlap, with random velocities.
fn start(radius: f64, seed: u64) -> Vec<Disc> {
    let mut random = Random::new(seed);
    let along = |k: u32| radius + (SIDE - 2.0 * radius) * f64::from(k) / f64::from(ALONG - 1);
    (0..ALONG * ALONG)
        .map(|k| {
            let mut v = || random.between(-SPEED, SPEED);
            Disc::new(along(k % ALONG), along(k / ALONG), v(), v())
        })
        .collect()
}

/// The greedy model in `steps` steps: where the discs end, and how many collisions there were. Its
/// steps have length 1, so velocities are scaled.
fn greedy(start: &[Disc], radius: f64, steps: u32) -> (Vec<Disc>, u64) {
    let length = TIME / f64::from(steps);
    let mut discs: Vec<_> =
        start.iter().map(|d| Disc::new(d.x, d.y, length * d.vx, length * d.vy)).collect();
    let mut collisions = 0;
    for _ in 0..steps {
        let (next, events) = step(&discs, SIDE, radius);
        collisions += events.len() as u64;
        discs = next;
    }
    (discs, collisions)
}
