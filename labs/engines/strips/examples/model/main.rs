//! Models programs on more ranks than this machine has cores.
//!
//! The methods are messages through the root, halos, lists on ranks, and deep ghosts. The time of a
//! step follows from the LogGP model of messages. The formulae are in chapters 6 and 13 of the
//! book.

mod blocks;
mod deep;
mod network;
mod step;

use std::process::ExitCode;

use anyhow::{Result, ensure};
use clap::Parser;
use lab_kit::machine::doubled_up_to;
use lab_kit::table::three_digits;
use lab_measure::autograder::{strong_efficiency, weak_efficiency};
use lab_measure::columns::Columns;
use lab_measure::numbers::Json;
use serde::Serialize;

use network::{Network, PUBLISHED};
use step::Method;

/// Model messages through the root, halos, lists, and deep ghosts, on many ranks: computed, not measured
///
/// You give the cost of a particle on one rank, in nanoseconds of a step. The cost of a message is
/// taken from published figures of three networks, and each result is the range of the three.
#[derive(Parser)]
#[command(name = "model")]
struct Options {
    /// Nanoseconds per particle and step on one rank: through the root, with halos, with lists, and
    /// with deep ghosts; the last one or two may be omitted
    #[arg(long, value_name = "ROOT,HALO,STRIPS,DEEP", value_delimiter = ',', required = true)]
    cost: Vec<f64>,
    /// Number of particles of the strong curve
    #[arg(short, default_value_t = 1_000_000_000, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    n: u32,
    /// Number of particles per rank of the weak curve
    #[arg(long, default_value_t = 1_000_000, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    per_rank: u32,
    /// Greatest number of ranks
    #[arg(long, default_value_t = 1024, value_name = "RANKS", value_parser = clap::value_parser!(u32).range(2..=1_048_576))]
    ranks: u32,
    #[command(flatten)]
    json: Json,
}

/// The strong and the weak curve of one method.
#[derive(Serialize)]
struct Curve {
    #[serde(rename = "lab")]
    method: Method,
    name: &'static str,
    /// Cost of a particle and step on one rank, in nanoseconds.
    #[serde(rename = "nanoseconds_per_particle_and_step")]
    cost: f64,
    strong: Vec<Point>,
    weak: Vec<Point>,
}

/// A step on a number of ranks, with each of the networks.
#[derive(Serialize)]
struct Point {
    ranks: f64,
    n: f64,
    #[serde(rename = "seconds_per_step")]
    seconds: [f64; 3],
    efficiency: [f64; 3],
}

#[derive(Serialize)]
struct Results {
    kind: &'static str,
    networks: [Network; 3],
    curves: Vec<Curve>,
}

fn main() -> ExitCode {
    lab_kit::command::finish(run(&Options::parse()))
}

fn run(options: &Options) -> Result<ExitCode> {
    let costs = &options.cost;
    ensure!((2..=4).contains(&costs.len()), "--cost needs two to four numbers");
    ensure!(costs.iter().all(|cost| *cost > 0.0 && cost.is_finite()), "a cost must be positive");
    let curves = Method::ALL.into_iter().zip(costs);
    let curves: Vec<Curve> =
        curves.map(|(method, cost)| Curve::new(method, *cost, options)).collect();
    print(&curves, options);
    let results = Results { kind: "model: computed, not measured", networks: PUBLISHED, curves };
    options.json.write_by("cargo run --release -p strips --example model --", results)?;
    Ok(ExitCode::SUCCESS)
}

impl Curve {
    fn new(method: Method, nanoseconds: f64, options: &Options) -> Self {
        let cost = nanoseconds * 1e-9;
        let (mut strong, mut weak) = (Vec::new(), Vec::new());
        for ranks in doubled_up_to(options.ranks as usize) {
            let p = ranks as f64;
            let n = f64::from(options.n);
            let seconds = PUBLISHED.map(|network| method.step(n, p, cost, &network));
            let efficiency = seconds.map(|all| strong_efficiency(n * cost, ranks, all));
            strong.push(Point { ranks: p, n, seconds, efficiency });
            let one = f64::from(options.per_rank);
            let seconds = PUBLISHED.map(|network| method.step(one * p, p, cost, &network));
            let efficiency = seconds.map(|all| weak_efficiency(one * cost, all));
            weak.push(Point { ranks: p, n: one * p, seconds, efficiency });
        }
        Self { method, name: method.variant(), cost: nanoseconds, strong, weak }
    }
}

fn print(curves: &[Curve], options: &Options) {
    println!("A model: computed, not measured. Each number is the range over three networks:\n");
    for network in PUBLISHED {
        println!("  {network}");
    }
    for curve in curves {
        println!("\n{}, {} ns per particle on one rank", curve.name, three_digits(curve.cost));
        println!("strong: n = {}; weak: {} per rank", options.n, options.per_rank);
        let rows: Vec<(&Point, &Point)> = curve.strong.iter().zip(&curve.weak).collect();
        let table = Columns::of("ranks", |(strong, _): &(&Point, &Point)| strong.ranks.to_string())
            .text("strong: ms a step", |(strong, _)| strong.milliseconds())
            .text("efficiency", |(strong, _)| strong.efficiency())
            .text("weak: ms a step", |(_, weak)| weak.milliseconds())
            .text("efficiency", |(_, weak)| weak.efficiency())
            .table(&rows);
        print!("{table}");
    }
}

impl Point {
    /// Formats the milliseconds of a step, from the fastest network to the slowest.
    fn milliseconds(&self) -> String {
        let mut seconds = self.seconds;
        seconds.sort_by(f64::total_cmp);
        format!("{} to {}", three_digits(1e3 * seconds[0]), three_digits(1e3 * seconds[2]))
    }

    /// Formats the efficiency, from the least to the greatest.
    fn efficiency(&self) -> String {
        let mut efficiency = self.efficiency;
        efficiency.sort_by(f64::total_cmp);
        format!("{:.2} to {:.2}", efficiency[0], efficiency[2])
    }
}
