//! `cargo lab model`: labs 5 and 6 on more ranks than there are here.

mod network;
mod step;

use std::process::ExitCode;

use anyhow::{Result, bail, ensure};
use clap::Args;
use serde_json::{Value, json};

use lab_kit::Kit;
use lab_kit::program::{Binaries, Program};
use lab_kit::table::{Table, three_digits};
use lab_measure::chart::{Axis, Chart, Series};
use lab_measure::job::{Job, Runner, Scene};
use lab_measure::record::Files;
use lab_measure::rounds::measure;
use lab_measure::rubric::{strong_efficiency, weak_efficiency};
use network::PUBLISHED;
use step::Lab;

/// Model labs 5 and 6 on many ranks: computed, not measured
///
/// The time of a step by the LogGP model of messages. What a particle costs is measured here, on one
/// rank of each lab; what a message costs is taken from published figures of three networks, and
/// each number is shown as the range between them. With --cost nothing is measured, and no MPI
/// library is needed. Chapter 6 has the formulae.
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
    /// Nanoseconds per particle and step of labs 5 and 6 on one rank [default: measured]
    #[arg(long, value_name = "LAB5,LAB6", value_delimiter = ',')]
    cost: Vec<f64>,
    #[command(flatten)]
    files: Files,
}

/// Particles, steps and rounds of the measurement of a particle's cost.
const TRY: (usize, u64, usize) = (1_000_000, 20, 3);

/// A lab's curve.
struct Curve {
    lab: Lab,
    name: &'static str,
    /// Seconds per particle and step on one rank.
    cost: f64,
    strong: Vec<Point>,
    weak: Vec<Point>,
}

/// A step on so many ranks, by each of the networks.
struct Point {
    ranks: f64,
    n: f64,
    seconds: Vec<f64>,
    efficiency: Vec<f64>,
}

/// Computes, prints, writes.
pub(crate) fn run(kit: &Kit, options: &Options) -> Result<ExitCode> {
    let costs = match options.cost[..] {
        [] => measured_costs(kit)?,
        [five, six] => [five * 1e-9, six * 1e-9],
        _ => bail!("--cost needs two numbers, of lab 5 and of lab 6"),
    };
    ensure!(costs.iter().all(|c| *c > 0.0 && c.is_finite()), "a cost must be positive");
    let curves = [(Lab::ThroughRoot, "lab 5 through-root"), (Lab::Halo, "lab 6 halo")];
    let curves: Vec<Curve> = curves
        .into_iter()
        .zip(costs)
        .map(|((lab, name), cost)| Curve::new(lab, name, cost, options))
        .collect();
    print(&curves, options);
    options.files.write(results(&curves), &charts(&curves, options))?;
    Ok(ExitCode::SUCCESS)
}

fn measured_costs(kit: &Kit) -> Result<[f64; 2]> {
    let programs: Vec<Program> = ["solution5:through-root,r=1", "solution6:halo,r=1"]
        .into_iter()
        .map(|text| text.parse().map_err(anyhow::Error::msg))
        .collect::<Result<_>>()?;
    let runner = Runner::new(Binaries::build(kit, &programs)?, &programs)?;
    let (n, steps, rounds) = TRY;
    let job = |program: Program| {
        let scene = Scene::Counter { n };
        Job { program, scene, steps, workers: 1, statistics: false }
    };
    let jobs: Vec<Job> = programs.into_iter().map(job).collect();
    let rounds = measure(&runner, &jobs, rounds)?;
    let cost = |at: usize| {
        let measured = &rounds.measured[at];
        1e-9 * measured.nanoseconds(measured.times.min())
    };
    Ok([cost(0), cost(1)])
}

impl Curve {
    fn new(lab: Lab, name: &'static str, cost: f64, options: &Options) -> Self {
        let greatest = f64::from(options.ranks);
        let mut ranks: Vec<f64> = std::iter::successors(Some(1.0), |p| Some(2.0 * p))
            .take_while(|p| *p < greatest)
            .collect();
        ranks.push(greatest);
        let seconds = |n: f64, p: f64| -> Vec<f64> {
            PUBLISHED.iter().map(|network| lab.step(n, p, cost, network)).collect()
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
        Self { lab, name, cost, strong: strong.collect(), weak: weak.collect() }
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
            "  L = {} µs, o = {} µs, g = {} µs, G = {} ns a byte: {}",
            three_digits(1e6 * network.latency),
            three_digits(1e6 * network.overhead),
            three_digits(1e6 * network.gap),
            three_digits(1e9 * network.per_byte),
            network.name
        );
    }
    for curve in curves {
        println!(
            "\n{}, {} ns per particle on one rank",
            curve.name,
            three_digits(1e9 * curve.cost)
        );
        let strong = format!("strong, n = {}: ms a step", options.n);
        let weak = format!("weak, {} per rank: ms a step", options.per_rank);
        let mut table = Table::new(["ranks", &strong, "efficiency", &weak, "efficiency"]);
        for (strong, weak) in curve.strong.iter().zip(&curve.weak) {
            let ms = |point: &Point| {
                let (low, high) = range(&point.seconds);
                format!("{} to {}", three_digits(1e3 * low), three_digits(1e3 * high))
            };
            let efficiency = |point: &Point| {
                let (low, high) = range(&point.efficiency);
                format!("{low:.2} to {high:.2}")
            };
            let ranks = strong.ranks.to_string();
            table.row([ranks, ms(strong), efficiency(strong), ms(weak), efficiency(weak)]);
        }
        print!("{table}");
    }
}

fn results(curves: &[Curve]) -> Value {
    let point = |p: &Point| {
        json!({ "ranks": p.ranks, "n": p.n, "seconds_per_step": p.seconds,
                "efficiency": p.efficiency })
    };
    let curves = curves.iter().map(|c| {
        json!({ "lab": format!("{:?}", c.lab), "name": c.name,
                "nanoseconds_per_particle_and_step": 1e9 * c.cost,
                "strong": c.strong.iter().map(point).collect::<Vec<_>>(),
                "weak": c.weak.iter().map(point).collect::<Vec<_>>() })
    });
    let networks = PUBLISHED.iter().map(|n| {
        json!({ "name": n.name, "latency": n.latency, "overhead": n.overhead, "gap": n.gap,
                "per_byte": n.per_byte })
    });
    json!({ "kind": "model: computed, not measured",
            "networks": networks.collect::<Vec<_>>(), "curves": curves.collect::<Vec<_>>() })
}

/// The time of a step on one scene, then the efficiency on scenes that grow.
fn charts(curves: &[Curve], options: &Options) -> Vec<Chart> {
    let line = |curve: &Curve, points: &[Point], of: fn(&Point) -> &[f64]| {
        let band = points.iter().map(|p| {
            let (low, high) = range(of(p));
            (p.ranks, low, high)
        });
        let line = points.iter().map(|p| (p.ranks, middle(of(p)))).collect();
        Series::model(curve.name, line).with_band(band.collect())
    };
    let ideal =
        curves[1].strong.iter().map(|p| (p.ranks, curves[1].cost * p.n / p.ranks)).collect();
    let strong = format!("Model: a step of n = {}, band over three networks", options.n);
    let weak = format!("Model: weak scaling, {} per rank", options.per_rank);
    let one = curves[1].weak.iter().map(|p| (p.ranks, 1.0)).collect();
    vec![
        Chart::new(strong, Axis::log("ranks"), Axis::log("time of a step [s]"))
            .with_all(curves.iter().map(|c| line(c, &c.strong, |p| &p.seconds)))
            .with(Series::guide("ideal, lab 6", ideal)),
        Chart::new(weak, Axis::log("ranks"), Axis::linear("efficiency").starting_at(0.0))
            .with_all(curves.iter().map(|c| line(c, &c.weak, |p| &p.efficiency)))
            .with(Series::guide("ideal", one)),
    ]
}
