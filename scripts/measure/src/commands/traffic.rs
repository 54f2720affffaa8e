//! `cargo lab traffic`: what ranks send, and what they hold.

use std::process::ExitCode;

use anyhow::{Result, ensure};
use clap::Args;
use serde_json::{Value, json};

use crate::chart::{Axis, Chart, Series};
use crate::job::{Job, Outcome, Scene};
use crate::record::Files;
use crate::rubric::slope;
use crate::subject::Subject;
use lab_kit::Kit;
use lab_kit::program::Program;
use lab_kit::progress::progress;
use lab_kit::table::{Table, three_digits};

/// Count what ranks send and hold
///
/// Runs a few steps of scenes of several sizes on several numbers of ranks and shows messages and
/// bytes per step, the memory of a rank, and the exponent of n with which the bytes grow. Counts
/// carry no noise, so nothing is repeated; but it takes some fifty steps until the particles have
/// left the lattice that they start on. The scenes are those of the counter-based generator, of
/// which a rank may make its share alone.
#[derive(Args)]
pub struct Options {
    #[command(flatten)]
    subject: Subject,
    /// Numbers of particles, separated by commas
    #[arg(short, default_value = "10000,100000,1000000", value_name = "N", value_delimiter = ',', value_parser = clap::value_parser!(u32).range(1..))]
    n: Vec<u32>,
    /// Numbers of ranks, separated by commas
    #[arg(long, default_value = "2", value_name = "RANKS", value_delimiter = ',', value_parser = clap::value_parser!(u16).range(1..))]
    ranks: Vec<u16>,
    /// Time steps of every run
    #[arg(long, default_value_t = 100, value_name = "STEPS", value_parser = clap::value_parser!(u64).range(1..))]
    steps: u64,
    /// Only look whether it works: small scenes
    #[arg(long, conflicts_with_all = ["n", "steps"])]
    quick: bool,
    #[command(flatten)]
    files: Files,
}

/// Counters of a rank, by the names that the labs give them, and the headings of their columns.
const COLUMNS: [(&str, &str); 6] = [
    ("messages per step, mean rank", "messages: mean"),
    ("messages per step, busiest rank", "busiest"),
    (BYTES, "bytes: mean"),
    ("bytes per step, busiest rank", "busiest"),
    ("resident MiB, mean rank", "MiB: mean"),
    ("resident MiB, largest rank", "largest"),
];

const BYTES: &str = "bytes per step, mean rank";

/// One run.
struct Point {
    program: Program,
    n: usize,
    ranks: usize,
    outcome: Outcome,
}

/// Counts, prints, writes.
pub fn run(kit: &Kit, mut options: Options) -> Result<ExitCode> {
    let package = options.subject.package()?;
    ensure!(
        package.has_ranks() && !package.is_hard(),
        "only labs 5 and 6 have ranks that count what they send"
    );
    if options.quick {
        (options.n, options.steps) = (vec![500, 2000], 5);
    }
    let (runner, programs) = options.subject.build(kit, &[], false)?;
    let mut points = Vec::new();
    let bar = progress((programs.len() * options.n.len() * options.ranks.len()) as u64);
    for program in &programs {
        for &ranks in &options.ranks {
            for &n in &options.n {
                let (n, ranks) = (n as usize, usize::from(ranks));
                let program = program.clone();
                let scene = Scene::Counter { n };
                let steps = options.steps;
                let job = Job { program, scene, steps, workers: ranks, statistics: false };
                let outcome = runner.run(&job)?;
                points.push(Point { program: job.program, n, ranks, outcome });
                bar.inc(1);
            }
        }
    }
    bar.finish_and_clear();
    let slopes = slopes(&points);
    print(&points, &slopes, options.steps);
    options.files.write(results(&points, &slopes), &[chart(&points)])?;
    Ok(ExitCode::SUCCESS)
}

/// The points of each program on each number of ranks, together.
fn lines(points: &[Point]) -> impl Iterator<Item = &[Point]> {
    points.chunk_by(|a, b| a.program == b.program && a.ranks == b.ranks)
}

fn bytes(line: &[Point]) -> Vec<(f64, f64)> {
    let point = |p: &Point| Some((p.n as f64, *p.outcome.counters.get(BYTES)?));
    line.iter().filter_map(point).filter(|(_, bytes)| *bytes > 0.0).collect()
}

/// For each program and number of ranks the exponent of n; not a number where nothing is sent.
fn slopes(points: &[Point]) -> Vec<(&Program, usize, f64)> {
    lines(points).map(|line| (&line[0].program, line[0].ranks, slope(&bytes(line)))).collect()
}

fn print(points: &[Point], slopes: &[(&Program, usize, f64)], steps: u64) {
    let header = ["program", "ranks", "n"].into_iter().chain(COLUMNS.map(|(_, title)| title));
    let mut table = Table::new(header);
    for Point { program, n, ranks, outcome } in points {
        let value = |name| outcome.counters.get(name).map_or(String::new(), |v| three_digits(*v));
        let cells = [program.to_string(), ranks.to_string(), n.to_string()];
        table.row(cells.into_iter().chain(COLUMNS.map(|(name, _)| value(name))));
    }
    println!("{table}\nPer step, over {steps} steps; memory is the most that a rank had.");
    for (program, ranks, slope) in slopes.iter().filter(|(.., slope)| slope.is_finite()) {
        println!("{program} on {ranks} ranks: the mean rank's bytes grow as n^{slope:.2}");
    }
}

fn results(points: &[Point], slopes: &[(&Program, usize, f64)]) -> Value {
    let runs = points.iter().map(|p| {
        json!({ "program": p.program.to_string(), "ranks": p.ranks, "n": p.n,
                "counters": p.outcome.counters })
    });
    let slopes = slopes.iter().map(|(program, ranks, slope)| {
        json!({ "program": program.to_string(), "ranks": ranks, "slope_of_bytes": slope })
    });
    json!({ "runs": runs.collect::<Vec<_>>(), "slopes": slopes.collect::<Vec<_>>() })
}

fn chart(points: &[Point]) -> Chart {
    let series = lines(points).map(|line| {
        Series::measured(format!("{}, {} ranks", line[0].program, line[0].ranks), bytes(line))
    });
    let guide: Vec<(f64, f64)> =
        lines(points).map(bytes).find(|b| !b.is_empty()).map_or(Vec::new(), |line| {
            let (n, bytes) = line[0];
            line.iter().map(|&(m, _)| (m, 0.7 * bytes * (m / n).sqrt())).collect()
        });
    let y = Axis::log("bytes per step, mean rank");
    Chart::new("What a rank sends", Axis::log("particles n"), y)
        .with_all(series)
        .with(Series::guide("slope 1/2", guide))
}
