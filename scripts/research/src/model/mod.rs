//! `cargo lab model`: messages through the root, halos, lists on ranks, and deep ghosts, on more ranks than
//! there are here.

mod blocks;
mod deep;
mod network;
mod step;

use std::process::ExitCode;

use anyhow::{Context, Result, bail, ensure};
use clap::Args;
use serde::{Deserialize, Serialize};

use lab_kit::machine::doubled_up_to;
use lab_kit::program::Program;
use lab_kit::table::three_digits;
use lab_kit::{Discs, Kit, Workers};
use lab_measure::chart::{Axis, Chart, Kind, Series, Sheet, number};
use lab_measure::columns::Columns;
use lab_measure::files::Files;
use lab_measure::fit::{Effort, Fit};
use lab_measure::job::Job;
use lab_measure::rubric::{strong_efficiency, weak_efficiency};
use lab_measure::runner::Runner;
use lab_measure::scene::Scene;
use network::{Network, PUBLISHED};
use step::Method;

/// Model messages through the root, halos, lists, and deep ghosts, on many ranks: computed, not measured
///
/// The time of a step by the LogGP model of messages. What a particle costs is measured here, on one
/// rank of each program; what a message costs is taken from published figures of three networks, and
/// each number is shown as the range between them. With --cost nothing is measured, and no MPI
/// library is needed. Chapters 6 and 13 have the formulae.
#[derive(Args)]
pub(crate) struct Options {
    /// Particles of the strong curve
    #[arg(short, default_value_t = 1_000_000_000, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    n: u32,
    /// Particles per rank of the weak curve
    #[arg(long, default_value_t = 1_000_000, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    per_rank: u32,
    /// Greatest number of ranks
    #[arg(long, default_value_t = 1024, value_name = "RANKS", value_parser = clap::value_parser!(u32).range(2..=1_048_576))]
    ranks: u32,
    /// Nanoseconds per particle and step on one rank, through the root, with halos, with lists, and with
    /// deep ghosts; the last, or the last two, may be left out [default: measured]
    #[arg(long, value_name = "ROOT,HALO,STRIPS,DEEP", value_delimiter = ',')]
    cost: Vec<f64>,
    #[command(flatten)]
    pub(crate) files: Files,
}

/// The measurement of a particle's cost.
const TRY: usize = 1_000_000;
const EFFORT: Effort = Effort { steps: Some(20), rounds: 3, seconds: 0.0 };

/// A method's curve.
#[derive(Deserialize, Serialize)]
struct Curve {
    #[serde(rename = "lab")]
    method: Method,
    name: String,
    /// On one rank.
    #[serde(rename = "nanoseconds_per_particle_and_step")]
    cost: f64,
    strong: Vec<Point>,
    weak: Vec<Point>,
}

/// A step on each number of ranks, by each of the networks.
#[derive(Deserialize, Serialize)]
struct Point {
    ranks: f64,
    n: f64,
    #[serde(rename = "seconds_per_step")]
    seconds: Vec<f64>,
    efficiency: Vec<f64>,
}

/// All numbers.
#[derive(Deserialize, Serialize)]
pub(crate) struct Results {
    kind: String,
    #[serde(skip_deserializing)]
    networks: [Network; 3],
    curves: Vec<Curve>,
}

impl Options {
    pub(crate) fn draw(&self, Results { curves, .. }: Results) -> Result<Sheet> {
        Ok(vec![charts(&curves, self)])
    }
}

/// Computes, prints, writes.
pub(crate) fn run(kit: &Kit, options: &Options) -> Result<ExitCode> {
    let costs = match options.cost.len() {
        0 => measured_costs(kit)?,
        2..=4 => options.cost.clone(),
        _ => {
            bail!("--cost needs two to four numbers: through the root, halos, lists, deep ghosts")
        }
    };
    ensure!(costs.iter().all(|c| *c > 0.0 && c.is_finite()), "a cost must be positive");
    let curves = Method::ALL.into_iter().zip(costs);
    let curves: Vec<Curve> =
        curves.map(|(method, cost)| Curve::new(method, cost, options)).collect();
    print(&curves, options);
    let kind = "model: computed, not measured".into();
    let results = Results { kind, networks: PUBLISHED, curves };
    options.files.write(results, |shown| options.draw(shown))?;
    Ok(ExitCode::SUCCESS)
}

/// Measures the solutions that have the methods' variants: nanoseconds per particle and step.
fn measured_costs(kit: &Kit) -> Result<Vec<f64>> {
    let packages = Program::solutions(kit, Discs::Soft, Workers::Ranks)?;
    let runner = Runner::build(kit, &packages)?;
    let mut known = Vec::new();
    for package in &packages {
        let variants = runner.binaries.variants(package)?;
        known.extend(variants.into_iter().map(|(program, _)| program));
    }
    let job = |method: Method| -> Result<Job> {
        let of = |program: &&Program| program.variant.as_deref() == Some(method.variant());
        let program = known.iter().find(of);
        let program = program.with_context(|| format!("no variant '{}'", method.variant()))?;
        Ok(Job::new(program.clone(), Scene::Counter { n: TRY }))
    };
    let jobs: Vec<Job> = Method::ALL.into_iter().map(job).collect::<Result<_>>()?;
    let records = EFFORT.run(&runner, jobs, Fit::Alike)?.records;
    Ok(records.iter().map(|record| record.nanoseconds.min).collect())
}

impl Curve {
    fn new(method: Method, nanoseconds: f64, options: &Options) -> Self {
        let cost = nanoseconds * 1e-9;
        let ranks = doubled_up_to(options.ranks as usize).into_iter().map(|p| p as f64);
        let ranks: Vec<f64> = ranks.collect();
        let seconds = |n: f64, p: f64| -> Vec<f64> {
            PUBLISHED.iter().map(|network| method.step(n, p, cost, network)).collect()
        };
        let (n, per_rank) = (f64::from(options.n), f64::from(options.per_rank));
        let strong = ranks.iter().map(|&p| {
            let seconds = seconds(n, p);
            let efficiency =
                seconds.iter().map(|t| strong_efficiency(n * cost, p as usize, *t)).collect();
            Point { ranks: p, n, seconds, efficiency }
        });
        let weak = ranks.iter().map(|&p| {
            let seconds = seconds(per_rank * p, p);
            let efficiency = seconds.iter().map(|t| weak_efficiency(per_rank * cost, *t)).collect();
            Point { ranks: p, n: per_rank * p, seconds, efficiency }
        });
        let (strong, weak) = (strong.collect(), weak.collect());
        Self { method, name: method.variant().into(), cost: nanoseconds, strong, weak }
    }
}

/// The least and the greatest.
fn range(values: &[f64]) -> (f64, f64) {
    values
        .iter()
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(*v), high.max(*v)))
}

/// The value of the network in the middle.
fn middle(values: &[f64]) -> f64 {
    values[values.len() / 2]
}

fn print(curves: &[Curve], options: &Options) {
    println!("A model: computed, not measured. Each number is the range over three networks:\n");
    for network in PUBLISHED {
        println!(
            "  {}:\n    L = {} µs, o = {} µs, g = {} µs, G = {} ns a byte",
            network.name,
            three_digits(1e6 * network.latency),
            three_digits(1e6 * network.overhead),
            three_digits(1e6 * network.gap),
            three_digits(1e9 * network.per_byte)
        );
    }
    for curve in curves {
        println!("\n{}, {} ns per particle on one rank", curve.name, three_digits(curve.cost));
        println!("strong: n = {}; weak: {} per rank", options.n, options.per_rank);
        let ms = |point: &Point| {
            let (low, high) = range(&point.seconds);
            format!("{} to {}", three_digits(1e3 * low), three_digits(1e3 * high))
        };
        let efficiency = |point: &Point| {
            let (low, high) = range(&point.efficiency);
            format!("{low:.2} to {high:.2}")
        };
        let rows: Vec<(&Point, &Point)> = curve.strong.iter().zip(&curve.weak).collect();
        let table = Columns::of("ranks", |(strong, _): &(&Point, &Point)| strong.ranks.to_string())
            .text("strong: ms a step", |(strong, _)| ms(strong))
            .text("efficiency", |(strong, _)| efficiency(strong))
            .text("weak: ms a step", |(_, weak)| ms(weak))
            .text("efficiency", |(_, weak)| efficiency(weak))
            .table(&rows);
        print!("{table}");
    }
}

/// The time of a step on one scene, then the efficiency on scenes that grow.
fn charts(curves: &[Curve], options: &Options) -> Vec<Chart> {
    let line = |curve: &Curve, points: &[Point], of: fn(&Point) -> &[f64]| {
        let band = points.iter().map(|p| {
            let (low, high) = range(of(p));
            (p.ranks, low, high)
        });
        let line = points.iter().map(|p| (p.ranks, middle(of(p)))).collect();
        Series::new(Kind::Model, &curve.name, line).with_band(band.collect())
    };
    let ideal =
        curves[1].strong.iter().map(|p| (p.ranks, 1e-9 * curves[1].cost * p.n / p.ranks)).collect();
    let strong = format!("Model: n = {}, band over three networks", number(options.n.into()));
    let weak = format!("Model: weak scaling, {} per rank", number(options.per_rank.into()));
    let one = curves[1].weak.iter().map(|p| (p.ranks, 1.0)).collect();
    // Labels with room between them, each four times the last.
    let ranks = || {
        let powers = std::iter::successors(Some(1.0), |p| Some(4.0 * p));
        let greatest = f64::from(options.ranks);
        Axis::log("ranks").with_ticks(powers.take_while(|p| *p <= greatest))
    };
    vec![
        Chart::new(strong, ranks(), Axis::log("time of a step [s]"))
            .with_all(curves.iter().map(|c| line(c, &c.strong, |p| &p.seconds)))
            .with(Series::new(Kind::Guide, "ideal", ideal)),
        Chart::new(weak, ranks(), Axis::linear("efficiency").starting_at(0.0))
            .with_all(curves.iter().map(|c| line(c, &c.weak, |p| &p.efficiency)))
            .with(Series::new(Kind::Guide, "ideal", one)),
    ]
}
