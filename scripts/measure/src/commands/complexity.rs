//! `cargo lab complexity`: how the time grows with the number of particles.

use std::process::ExitCode;

use anyhow::{Result, ensure};
use clap::Args;
use serde::{Deserialize, Serialize};

use crate::axis::Axis;
use crate::chart::{self, Chart, Kind, Series, Sheet};
use crate::clock::{Span, TOO_SHORT, warning};
use crate::columns::Columns;
use crate::experiment::{Bound, Record, Records};
use crate::files::Files;
use crate::fit::{Effort, Fit, MOST_STEPS};
use crate::job::Job;
use crate::published;
use crate::rubric::{complexity_grade, slope, slopes};
use crate::runner::Runner;
use crate::scene::Discs;
use crate::subject::Subject;
use lab_kit::Kit;
use lab_kit::program::Program;
use lab_kit::table::Table;

/// Measure how the time grows with the number of particles, and grade it
///
/// Times a variant on scenes that double in size and fits a line through the points on
/// logarithmic axes: its slope is the exponent of n. The pairs that the program looks at are
/// counted as well, which no noise disturbs. A slope below 1.3 by time earns the full grade.
#[derive(Args)]
pub struct Options {
    #[command(flatten)]
    subject: Subject,
    /// Least number of particles
    #[arg(long, default_value_t = 1000, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    from: u32,
    /// Greatest number of particles [default: 128000; 16000 hard discs]
    #[arg(long, value_name = "N")]
    to: Option<u32>,
    /// Numbers of threads, or ranks, separated by commas
    #[arg(short, default_value = "1", value_name = "WORKERS", value_delimiter = ',', value_parser = clap::value_parser!(u16).range(1..))]
    t: Vec<u16>,
    #[command(flatten)]
    discs: Discs,
    #[command(flatten)]
    effort: Effort,
    #[command(flatten)]
    pub(super) files: Files,
}

/// One program's times over all sizes.
#[derive(Deserialize, Serialize)]
struct Line {
    program: Program,
    workers: usize,
    slope_by_time: f64,
    slope_by_median: f64,
    slope_by_pair_tests: Option<f64>,
    grade: f64,
    points: Vec<Point>,
}

#[derive(Deserialize, Serialize)]
struct Point {
    #[serde(flatten)]
    record: Record,
    /// Pairs looked at in a step; none where the program does not count them.
    pair_tests_per_step: Option<f64>,
}

/// All numbers.
#[derive(Deserialize, Serialize)]
pub struct Results {
    lines: Vec<Line>,
    streaming_bound: Vec<Bound>,
}

impl Options {
    pub(super) fn draw(&self, Results { lines, .. }: Results) -> Result<Sheet> {
        Ok(vec![vec![chart(&lines)]])
    }
}

/// Measures, prints, writes.
pub fn run(kit: &Kit, options: Options) -> Result<ExitCode> {
    let hard = options.subject.package()?.is_hard();
    let (from, to) = (options.from, options.to.unwrap_or(if hard { 16_000 } else { 128_000 }));
    ensure!(from < to, "--from {from} must be less than --to {to}");
    let doubled = std::iter::successors(Some(from), |n| n.checked_mul(2));
    let sizes: Vec<f64> = doubled.take_while(|n| *n <= to).map(f64::from).collect();
    ensure!(sizes.len() > 1, "--to {to} must be at least twice --from {from}");

    let (runner, programs) = options.subject.build(kit, &[], false)?;
    let mut jobs = Vec::new();
    let scene = options.discs.scene(None, hard)?;
    for program in programs {
        for &workers in &options.t {
            let like = Job { workers: workers.into(), ..Job::new(program.clone(), scene.clone()) };
            jobs.extend(Axis::N.jobs(&sizes, std::slice::from_ref(&program), &like));
        }
    }
    let fit = Fit::Each { most: MOST_STEPS, affordable: true };
    let records = options.effort.run(&runner, jobs, fit)?;
    eprint!("{}", records.left_out_in_words());
    let same =
        |a: &Record, b: &Record| a.job.program == b.job.program && a.job.workers == b.job.workers;
    let lines = records.records.chunk_by(same).map(|line| Line::new(&runner, line));
    let lines: Vec<Line> = lines.collect::<Result<_>>()?;
    for line in &lines {
        println!("{}\n\n{}\n{}\n", line.name(), table(line, &records), line.verdict());
    }
    options
        .files
        .write(Results { lines, streaming_bound: records.bounds }, |shown| options.draw(shown))?;
    Ok(ExitCode::SUCCESS)
}

/// Pairs looked at in a step: the average of some, as the start, a lattice, is no typical scene.
fn pair_tests(runner: &Runner, job: &Job) -> Result<Option<f64>> {
    let few = job.steps.min(100);
    let outcome =
        runner.run(&Job { steps: few, statistics: !job.program.is_hard(), ..job.clone() })?;
    let counted = outcome.counters.get("pair tests").map(|total| total / few as f64);
    let averaged = outcome.statistics.map(|s| s.pair_tests * job.scene.n() as f64);
    Ok(averaged.or(counted))
}

impl Line {
    /// Fits slopes to times, and counts the pairs in short runs of their own.
    fn new(runner: &Runner, records: &[Record]) -> Result<Self> {
        let Job { program, workers, .. } = records[0].job.clone();
        let point = |record: &Record| -> Result<Point> {
            let pair_tests_per_step = pair_tests(runner, &record.job)?;
            Ok(Point { record: record.clone(), pair_tests_per_step })
        };
        let points: Vec<Point> = records.iter().map(point).collect::<Result<_>>()?;
        let slope_of = slopes(&points.iter().map(|p| (p.n(), p.record.ms())).collect::<Vec<_>>());
        let pairs = |p: &Point| Some((p.n(), p.pair_tests_per_step?));
        let pairs: Vec<_> = points.iter().filter_map(pairs).collect();
        Ok(Self {
            program,
            workers,
            slope_by_time: slope_of.min,
            slope_by_median: slope_of.median,
            slope_by_pair_tests: (pairs.len() > 1).then(|| slope(&pairs)),
            grade: complexity_grade(slope_of.min),
            points,
        })
    }

    /// What the tables and the chart call it.
    fn name(&self) -> String {
        match self.workers {
            1 => self.program.to_string(),
            p if self.program.has_ranks() => format!("{}, {p} ranks", self.program),
            p => format!("{}, {p} threads", self.program),
        }
    }

    fn verdict(&self) -> String {
        let Self { slope_by_time, slope_by_median, grade, .. } = self;
        let pairs = self.slope_by_pair_tests.map_or_else(String::new, |slope| {
            format!(",\nthe pairs that are looked at, averaged over 100 steps at most, as n to the power {slope:.3}")
        });
        let by_median = complexity_grade(*slope_by_median);
        let spread = warning(Span { min: *grade, median: by_median }, *slope_by_median);
        let grade = match self.points.iter().any(|point| point.record.times.are_too_short()) {
            true => TOO_SHORT.into(),
            false => format!("Grade: {grade:.2} of 100.{spread}"),
        };
        format!("The time grows as n to the power {slope_by_time:.3}{pairs}. {grade}")
    }
}

impl Point {
    fn n(&self) -> f64 {
        self.record.job.scene.n() as f64
    }
}

fn table(line: &Line, records: &Records) -> Table {
    // From the scene before; none for the first.
    let slope_to = |point: &Point, y: fn(&Point) -> Option<f64>| {
        let at = line.points.iter().position(|p| std::ptr::eq(p, point))?;
        let of = |p: &Point| Some((p.n(), y(p)?));
        let slope = slope(&[of(line.points.get(at.checked_sub(1)?)?)?, of(point)?]);
        Some(format!("{slope:.2}"))
    };
    let bound = |point: &Point| records.bound(point.n() as usize, line.workers > 1);
    Columns::of("n", |point: &Point| point.n().to_string())
        .text("steps", |point| point.record.job.steps.to_string())
        .times("ms a step: ", |point| point.record.ms())
        .perhaps("slope", |point| slope_to(point, |p| Some(p.record.ms().min)))
        .number("ns per particle", |point| Some(point.record.nanoseconds.min))
        .number("pair tests per particle", |point| Some(point.pair_tests_per_step? / point.n()))
        .perhaps("slope", |point| slope_to(point, |p| p.pair_tests_per_step))
        .number("streaming bound [ns]", |point| Some(bound(point)))
        .table(&line.points)
}

/// Programs whose time grows nearly as n are told apart by what a particle costs them; of the others the time is
/// shown. Reports stand beside. Of several numbers of workers only the greatest is drawn.
fn chart(lines: &[Line]) -> Chart {
    const NEARLY: f64 = 1.5;
    let most = lines.iter().map(|line| line.workers).max().unwrap_or(1);
    let lines: Vec<&Line> = lines.iter().filter(|line| line.workers == most).collect();
    let hard = lines.iter().any(|line| line.program.is_hard());
    let each = lines.iter().all(|line| line.slope_by_time < NEARLY);
    let steps = if hard { published::HARD_STEPS } else { published::SOFT_STEPS };
    let shown = |n: f64, seconds: f64| (n, if each { 1e9 * seconds / steps / n } else { seconds });
    let ours = |line: &Line| -> Vec<(f64, f64)> {
        line.points.iter().map(|p| shown(p.n(), p.record.ms().min * 1e-3 * steps)).collect()
    };
    let what = if hard { "disc" } else { "particle" };
    let (title, y) = match each {
        true => (format!("Time of a {what} in a step"), format!("ns a {what} and step")),
        false => (format!("Time of {steps} steps"), "time [s]".into()),
    };
    let measured = lines.iter().map(|line| Series::new(Kind::Measured, line.name(), ours(line)));
    let chart = Chart::new(title, chart::Axis::log(format!("{what}s n")), chart::Axis::log(y))
        .with_all(measured)
        .with_all(beside(hard, most > 1).iter().map(|name| {
            let report = published::growth(name);
            let points = report.points.iter().map(|&(n, seconds)| shown(n, seconds));
            Series::new(Kind::Published, &report.name, points.collect())
        }));
    let all: Vec<_> = lines.iter().flat_map(|line| ours(line)).collect();
    if each { chart } else { chart.with_all(guides(&all)) }
}

/// The tables of the course reports that belong beside these lines.
fn beside(hard: bool, parallel: bool) -> &'static [&'static str] {
    match (hard, parallel) {
        (true, _) => &["cs3210-openmp-growth", "cs3210-cuda-growth", "cs3210-mpi-growth"],
        (false, true) => &["cs267-4-threads", "cs267-32-threads"],
        (false, false) => &["csc581-serial", "csc367-serial", "cs267-preliminary", "cs267-final"],
    }
}

/// Lines of slope 1 and 2 through the lower left corner of what was measured, as far as the points go to
/// the right and upwards.
fn guides(points: &[(f64, f64)]) -> [Series; 2] {
    let (mut first, mut low, mut last, mut high) = (f64::INFINITY, f64::INFINITY, 0.0_f64, 0.0_f64);
    for &(x, y) in points {
        (first, low, last, high) = (first.min(x), low.min(0.7 * y), last.max(x), high.max(y));
    }
    [1, 2].map(|power| {
        let reach = (last / first).min((2.0 * high / low).powf(1.0 / f64::from(power)));
        let end = (first * reach, low * reach.powi(power));
        Series::new(Kind::Guide, format!("slope {power}"), vec![(first, low), end])
    })
}
