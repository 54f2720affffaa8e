//! `cargo lab traffic`: the messages of ranks, and their memory.

use std::collections::BTreeMap;

use anyhow::{Result, ensure};
use clap::Args;
use serde::{Deserialize, Serialize};

use crate::autograder::slope;
use crate::chart::{Axis, Chart, Kind, Series, Sheet};
use crate::columns::Columns;
use crate::experiment::one_by_one;
use crate::job::Job;
use crate::numbers::Files;
use crate::scene::Scene;
use crate::subject::Subject;
use lab_kit::Kit;
use lab_kit::program::Program;
use lab_kit::table::Table;

/// Count what ranks send and hold
///
/// Runs a few steps of scenes of several sizes on several numbers of ranks. Shows messages and
/// bytes per step, the memory of a rank, and the exponent of n in the growth of the bytes. Counts
/// have no noise, so runs are not repeated. However, the particles need about fifty steps to leave
/// the lattice at the start. The scenes are those of the counter-based generator, which lets each
/// rank make only its share.
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
    /// Number of time steps of every run
    #[arg(long, default_value_t = 100, value_name = "STEPS", value_parser = clap::value_parser!(u64).range(1..))]
    steps: u64,
    #[command(flatten)]
    pub(super) files: Files,
}

/// Names of a rank's counters, and the headings of their columns.
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

#[derive(Deserialize, Serialize)]
struct Point {
    program: Program,
    ranks: usize,
    n: usize,
    counters: BTreeMap<String, f64>,
}

/// Exponent of n in the growth of a program's bytes, on a number of ranks; `None` if it sends none.
#[derive(Deserialize, Serialize)]
struct Slope {
    program: Program,
    ranks: usize,
    slope_of_bytes: Option<f64>,
}

#[derive(Deserialize, Serialize)]
pub(super) struct Results {
    runs: Vec<Point>,
    slopes: Vec<Slope>,
}

impl Options {
    pub(super) fn draw(&self, Results { runs, .. }: Results) -> Result<Sheet> {
        Ok(vec![vec![chart(&runs)]])
    }
}

pub(super) fn run(kit: &Kit, options: Options) -> Result<()> {
    let package = options.subject.package()?;
    ensure!(
        package.has_ranks() && !package.is_hard(),
        "only labs of soft discs on ranks count what they send"
    );
    let (runner, programs) = options.subject.build(kit, &[], false)?;
    let steps = options.steps;
    let mut jobs = Vec::new();
    for program in &programs {
        for &ranks in &options.ranks {
            for &n in &options.n {
                let job = Job::new(program.clone(), Scene::Counter { n: n as usize });
                jobs.push(Job { steps, workers: ranks.into(), ..job });
            }
        }
    }
    let runs = one_by_one(&jobs, Job::name, |job| {
        let counters = runner.run(job)?.counters;
        let n = job.scene.n();
        Ok(Point { program: job.program.clone(), ranks: job.workers, n, counters })
    })?;
    println!("{}\nPer step, over {steps} steps; memory is the most that a rank had.", table(&runs));
    let mut slopes = Vec::new();
    for line in lines(&runs) {
        let Point { program, ranks, .. } = &line[0];
        let slope = slope(&bytes(line));
        if slope.is_finite() {
            println!("{program} on {ranks} ranks: the mean rank's bytes grow as n^{slope:.2}");
        }
        let slope_of_bytes = slope.is_finite().then_some(slope);
        slopes.push(Slope { program: program.clone(), ranks: *ranks, slope_of_bytes });
    }
    options.files.write(Results { runs, slopes }, |shown| options.draw(shown))
}

/// Iterates over the runs of each program on each number of ranks.
fn lines(points: &[Point]) -> impl Iterator<Item = &[Point]> {
    points.chunk_by(|a, b| a.program == b.program && a.ranks == b.ranks)
}

/// Returns the bytes against n, without runs that send nothing.
fn bytes(line: &[Point]) -> Vec<(f64, f64)> {
    let points =
        line.iter().filter_map(|point| Some((point.n as f64, *point.counters.get(BYTES)?)));
    points.filter(|(_, bytes)| *bytes > 0.0).collect()
}

fn table(points: &[Point]) -> Table {
    Columns::of("program", |point: &Point| point.program.to_string())
        .text("ranks", |point| point.ranks.to_string())
        .text("n", |point| point.n.to_string())
        .numbers(COLUMNS.map(|(_, title)| title), |point, at| {
            point.counters.get(COLUMNS[at].0).copied()
        })
        .table(points)
}

fn chart(points: &[Point]) -> Chart {
    let mut chart = Chart::new("What a rank sends", Axis::log("particles n"), Axis::log(BYTES));
    for line in lines(points) {
        let name = format!("{}, {} ranks", line[0].program, line[0].ranks);
        chart = chart.with(Series::new(Kind::Measured, name, bytes(line)));
    }
    let first = lines(points).map(bytes).find(|line| !line.is_empty()).unwrap_or_default();
    let guide =
        first.iter().map(|&(m, _)| (m, 0.7 * first[0].1 * (m / first[0].0).sqrt())).collect();
    chart.with(Series::new(Kind::Guide, "slope 1/2", guide))
}
