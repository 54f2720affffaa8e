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

/// Measure the greedy rule of the hard discs (labs 7 to 9) against the exact motion
#[derive(Args)]
pub(crate) struct Options {
    /// Part of the square that the discs cover
    #[arg(long, default_value_t = 0.1, value_parser = fraction)]
    fraction: f64,
    /// Scenes to average over
    #[arg(long, default_value_t = 20, value_parser = clap::value_parser!(u64).range(1..=1000))]
    scenes: u64,
}

/// Discs along a side of the start's lattice, its side, and the time that passes.
const ALONG: u32 = 10;
const SIDE: f64 = 100.0;
const TIME: f64 = 16.0;

/// The greatest velocity component.
const SPEED: f64 = 2.0;

pub(crate) fn run(options: &Options) -> Result<ExitCode> {
    let n = ALONG * ALONG;
    let radius = (options.fraction * SIDE * SIDE / (f64::from(n) * PI)).sqrt();
    println!("{n} discs of radius {radius:.3} in a square of side {SIDE}, until time {TIME}");
    println!(
        "{:>6} {:>10} {:>12} {:>12} {:>12}",
        "steps", "way / r", "collisions", "of exact", "error / r"
    );
    for doubling in 0..=10 {
        let steps = 1_u32 << doubling;
        let (mut taken, mut exact, mut error) = (0, 0, 0.0);
        for seed in 0..options.scenes {
            let start = start(radius, seed);
            let mut truth = Exact::new(&start, SIDE, radius);
            let end = truth.run_until(TIME);
            let (found, collisions) = greedy(&start, radius, steps);
            taken += collisions;
            exact += truth.collisions();
            let off = |(a, b): (&Disc, &Disc)| (a.position() - b.position()).norm_squared().sqrt();
            error += found.iter().zip(&end).map(off).sum::<f64>() / f64::from(n);
        }
        let scenes = options.scenes as f64;
        // The mean magnitude of a velocity whose components are even in −SPEED … SPEED.
        let way = 0.765 * SPEED * TIME / f64::from(steps) / radius;
        println!(
            "{steps:>6} {way:>10.3} {:>12.1} {:>11.1}% {:>12.5}",
            taken as f64 / scenes,
            100.0 * taken as f64 / exact as f64,
            error / scenes / radius
        );
    }
    Ok(ExitCode::SUCCESS)
}

/// Discs on a lattice, so that none overlap, with random velocities.
fn start(radius: f64, seed: u64) -> Vec<Disc> {
    let mut random = Random::new(seed);
    let place = |k: u32| radius + (SIDE - 2.0 * radius) * f64::from(k) / f64::from(ALONG - 1);
    (0..ALONG * ALONG)
        .map(|k| {
            let mut v = || random.between(-SPEED, SPEED);
            Disc::new(place(k % ALONG), place(k / ALONG), v(), v())
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

fn fraction(text: &str) -> Result<f64, String> {
    let value: f64 = text.parse().map_err(|_| format!("'{text}' is not a number"))?;
    // On the start's lattice discs touch at π/4 of a square that is a little smaller.
    if (1e-6..=0.5).contains(&value) { Ok(value) } else { Err("must lie in 1e-6 to 0.5".into()) }
}
