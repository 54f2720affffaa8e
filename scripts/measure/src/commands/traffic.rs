//! `cargo lab traffic`: what ranks send, and what they hold.

use std::collections::BTreeMap;
use std::process::ExitCode;

use anyhow::{Result, ensure};
use clap::Args;
use serde::{Deserialize, Serialize};

use crate::chart::{Axis, Chart, Kind, Series, Sheet};
use crate::columns::Columns;
use crate::experiment::in_turns;
use crate::files::Files;
use crate::job::{Job, Outcome};
use crate::rubric::slope;
use crate::scene::Scene;
use crate::subject::Subject;
use lab_kit::Kit;
use lab_kit::program::Program;
use lab_kit::table::Table;

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
    #[command(flatten)]
    pub(super) files: Files,
}

/// Counters of a rank, by the names that the labs give them, and the headings of their columns.
const COLUMNS: [(&str, &str); 7] = [
    ("messages per step, mean rank", "messages: mean"),
    ("messages per step, busiest rank", "busiest"),
    (BYTES, "bytes: mean"),
    ("bytes per step, busiest rank", "busiest"),
    ("resident MiB, mean rank", "MiB: mean"),
    ("resident MiB, largest rank", "largest"),
    ("particles, fullest rank", "particles: fullest"),
];

const BYTES: &str = "bytes per step, mean rank";

/// One run.
#[derive(Deserialize, Serialize)]
struct Point {
    program: Program,
    ranks: usize,
    n: usize,
    counters: BTreeMap<String, f64>,
}

/// A program's exponent of n on a number of ranks; none where nothing is sent.
#[derive(Deserialize, Serialize)]
struct Slope {
    program: Program,
    ranks: usize,
    slope_of_bytes: Option<f64>,
}

/// All numbers.
#[derive(Deserialize, Serialize)]
pub struct Results {
    runs: Vec<Point>,
    slopes: Vec<Slope>,
}

impl Options {
    pub(super) fn draw(&self, Results { runs, .. }: Results) -> Result<Sheet> {
        Ok(vec![vec![chart(&runs)]])
    }
}

/// Counts, prints, writes.
pub fn run(kit: &Kit, options: Options) -> Result<ExitCode> {
    let package = options.subject.package()?;
    ensure!(
        package.has_ranks() && !package.is_hard(),
        "only labs of soft discs on ranks count what they send"
    );
    let (runner, programs) = options.subject.build(kit, &[], false)?;
    let (steps, mut jobs) = (options.steps, Vec::new());
    for program in &programs {
        for &ranks in &options.ranks {
            jobs.extend(options.n.iter().map(|&n| {
                let job = Job::new(program.clone(), Scene::Counter { n: n as usize });
                Job { steps, workers: ranks.into(), ..job }
            }));
        }
    }
    let name = |job: &Job| format!("{} n={}", job.program, job.scene.n());
    let outcomes = in_turns(&jobs, 1, name, |job| runner.run(job))?.into_iter().flatten();
    let point = |(Job { program, scene, workers: ranks, .. }, outcome): (Job, Outcome)| Point {
        program,
        ranks,
        n: scene.n(),
        counters: outcome.counters,
    };
    let runs: Vec<Point> = jobs.into_iter().zip(outcomes).map(point).collect();
    let slope_of = |line: &[Point]| {
        let slope = Some(slope(&bytes(line))).filter(|slope| slope.is_finite());
        Slope { program: line[0].program.clone(), ranks: line[0].ranks, slope_of_bytes: slope }
    };
    let slopes: Vec<Slope> = lines(&runs).map(slope_of).collect();
    println!("{}\nPer step, over {steps} steps; memory is the most that a rank had.", table(&runs));
    for Slope { program, ranks, slope_of_bytes } in &slopes {
        if let Some(slope) = slope_of_bytes {
            println!("{program} on {ranks} ranks: the mean rank's bytes grow as n^{slope:.2}");
        }
    }
    options.files.write(Results { runs, slopes }, |shown| options.draw(shown))?;
    Ok(ExitCode::SUCCESS)
}

/// The points of each program on each number of ranks, together.
fn lines(points: &[Point]) -> impl Iterator<Item = &[Point]> {
    points.chunk_by(|a, b| a.program == b.program && a.ranks == b.ranks)
}

fn bytes(line: &[Point]) -> Vec<(f64, f64)> {
    let point = |p: &Point| Some((p.n as f64, *p.counters.get(BYTES)?));
    line.iter().filter_map(point).filter(|(_, bytes)| *bytes > 0.0).collect()
}

fn table(points: &[Point]) -> Table {
    let counted = |point: &Point, at: usize| point.counters.get(COLUMNS[at].0).copied();
    Columns::of("program", |point: &Point| point.program.to_string())
        .text("ranks", |point| point.ranks.to_string())
        .text("n", |point| point.n.to_string())
        .numbers(COLUMNS.map(|(_, title)| title), counted)
        .table(points)
}

fn chart(points: &[Point]) -> Chart {
    let series = lines(points).map(|line| {
        Series::new(
            Kind::Measured,
            format!("{}, {} ranks", line[0].program, line[0].ranks),
            bytes(line),
        )
    });
    let first = lines(points).map(bytes).find(|line| !line.is_empty()).unwrap_or_default();
    let guide =
        first.iter().map(|&(m, _)| (m, 0.7 * first[0].1 * (m / first[0].0).sqrt())).collect();
    Chart::new("What a rank sends", Axis::log("particles n"), Axis::log(BYTES))
        .with_all(series)
        .with(Series::new(Kind::Guide, "slope 1/2", guide))
}
