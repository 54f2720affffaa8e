//! `cargo lab sweep`: variants side by side while one thing varies.

use std::collections::BTreeMap;
use std::process::ExitCode;

use anyhow::Result;
use clap::Args;
use serde::{Deserialize, Serialize};
use serde_json::Value;

use crate::axis::{Axis, Over};
use crate::chart::{self, Chart, Series, Sheet};
use crate::clock::{Ratio, Span, times_longer};
use crate::experiment::{Bound, Effort, Record};
use crate::files::{Figure, Files};
use crate::job::Job;
use crate::published::{self, HARD_STEPS, Report};
use crate::scene::{Discs, Random, Scene};
use crate::subject::Subject;
use lab_kit::Kit;
use lab_kit::table::{Table, three_digits};

/// Measure variants while one thing varies: n, the square, the radius, neighbours, threads, a parameter
///
/// 'cargo lab sweep 7 --solution --variant outer-dynamic,planned -t 2 --over radius' takes the
/// values of the CS3210 report; '--over n=1000,10000' takes these. All runs take turns, round after
/// round. Shown are the shortest take and the median, how both compare with the first variant's at
/// the same value, the pairs looked at, and what the report printed.
/// A run has at most 50 steps, as in the report, unless --steps says otherwise.
#[derive(Args)]
pub struct Options {
    #[command(flatten)]
    subject: Subject,
    /// What varies: n, length, radius, neighbours, threads, ranks or a parameter's name; perhaps with
    /// its values
    #[arg(long, value_name = "WHAT[=VALUES]")]
    over: Over,
    /// Number of particles [default: 100000; 10000 hard discs]
    #[arg(short, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    n: Option<u32>,
    #[command(flatten)]
    discs: Discs,
    /// Threads, or ranks
    #[arg(short, default_value_t = 1, value_name = "WORKERS", value_parser = clap::value_parser!(u16).range(1..))]
    t: u16,
    #[command(flatten)]
    effort: Effort,
    #[command(flatten)]
    files: Files,
}

/// One variant at one value.
#[derive(Serialize)]
struct Cell {
    #[serde(flatten)]
    record: Record,
    #[serde(skip)]
    at: f64,
    /// The value, under the axis' name, where the record has none.
    #[serde(flatten)]
    value: Option<BTreeMap<String, f64>>,
    variant: String,
    ms_per_step: Span,
    pair_tests_per_step: Option<f64>,
    report_ms_per_step: Option<Report>,
    /// Against the first variant at the same value; none for the first.
    #[serde(skip)]
    ratio: Option<Ratio>,
}

#[derive(Serialize)]
struct Results<'r> {
    over: String,
    runs: &'r [Cell],
    streaming_bound: &'r [Bound],
}

/// What the figure shows of the results.
#[derive(Deserialize)]
pub struct Runs {
    runs: Vec<Run>,
}

/// One variant at one value.
#[derive(Deserialize)]
struct Run {
    #[serde(flatten)]
    record: Record,
    /// Where the value is.
    #[serde(flatten)]
    rest: BTreeMap<String, Value>,
    variant: String,
    ms_per_step: Span,
    report_ms_per_step: Option<Value>,
}

impl Figure for Options {
    type Shown = Runs;

    fn files(&self) -> &Files {
        &self.files
    }

    fn draw(&self, Runs { runs }: Runs) -> Result<Sheet> {
        Ok(vec![vec![chart(&self.over.axis, &runs)]])
    }
}

impl Run {
    fn at(&self, axis: &Axis) -> f64 {
        let value = || self.rest.get(&axis.to_string())?.as_f64();
        match axis {
            Axis::N => self.record.job.scene.n() as f64,
            _ => value().unwrap_or(f64::NAN),
        }
    }
}

/// Measures, prints, writes.
pub fn run(kit: &Kit, options: Options) -> Result<ExitCode> {
    let (runner, programs) = options.subject.build(kit, &[], false)?;
    let (axis, values) = (&options.over.axis, options.over.values(&programs[0])?);
    let scene = options.discs.scene(options.n.map(|n| n as usize), programs[0].is_hard())?;
    let like = Job { workers: options.t.into(), ..Job::new(programs[0].clone(), scene) };
    let experiment = options.effort.experiment(&runner, axis.jobs(&values, &programs, &like));
    let records = experiment.calibrate_each(HARD_STEPS as u64, |_, _| true)?.run()?;
    let rows = values.iter().zip(records.records.chunks(programs.len()));
    let cells: Vec<Cell> = rows
        .flat_map(|(&value, row)| row.iter().map(move |cell| Cell::new(axis, value, cell, &row[0])))
        .collect();
    println!("{}\n{}", table(axis, &cells), records.bounds_in_words());
    let results =
        Results { over: axis.to_string(), runs: &cells, streaming_bound: &records.bounds };
    options.write(results)?;
    Ok(ExitCode::SUCCESS)
}

impl Cell {
    fn new(axis: &Axis, value: f64, record: &Record, first: &Record) -> Self {
        let program = &record.job.program;
        let step = |record: &Record| record.times.scaled(1.0 / record.job.steps as f64);
        let is_first = std::ptr::eq(record, first);
        Self {
            at: value,
            value: (!workers(axis)).then(|| BTreeMap::from([(axis.to_string(), value)])),
            variant: program.variant.clone().unwrap_or_else(|| program.package()),
            ms_per_step: record.ms(),
            pair_tests_per_step: record.per_step("pair tests"),
            report_ms_per_step: report(axis, value, record),
            ratio: (!is_first).then(|| step(record).over(&step(first))),
            record: record.clone(),
        }
    }
}

fn workers(axis: &Axis) -> bool {
    matches!(axis, Axis::Threads | Axis::Ranks)
}

/// What the CS3210 report has for the same program on the same scene, on its own machine: ms a step.
fn report(axis: &Axis, value: f64, record: &Record) -> Option<Report> {
    let Scene::Hard { n, side, radius, random } = record.job.scene else { return None };
    if random != Random::default() {
        return None;
    }
    let program = &record.job.program;
    let workers = workers(axis).then_some(value as usize);
    let variant = program.variant.as_deref()?;
    let report = published::hard_discs(program.workers(), variant, (n, side, radius), workers)?;
    Some(report.scaled(1e3 / HARD_STEPS))
}

/// A row for each variant at each value; a column that nothing fills is left out.
fn table(axis: &Axis, cells: &[Cell]) -> Table {
    let name = axis.to_string();
    let mut header = vec![
        &*name,
        "variant",
        "ms a step: min",
        "median",
        "spread",
        "ratio of min",
        "of median",
        "decided",
    ];
    let counted = cells.iter().any(|cell| cell.pair_tests_per_step.is_some());
    let published = cells.iter().any(|cell| cell.report_ms_per_step.is_some());
    header.extend(counted.then_some("pair tests a step"));
    header.extend(published.then_some("report, ms"));
    let mut table = Table::new(header);
    for cell in cells {
        let times = &cell.record.times;
        let ratio = |of: fn(&Ratio) -> String| cell.ratio.as_ref().map_or_else(String::new, of);
        let mut row = vec![
            cell.at.to_string(),
            cell.variant.clone(),
            three_digits(cell.ms_per_step.min),
            three_digits(cell.ms_per_step.median),
            format!("{:.0} %", 100.0 * times.spread()),
            cell.ratio.map_or("1".into(), |ratio| times_longer(ratio.of_minima)),
            cell.ratio.map_or("1".into(), |ratio| times_longer(ratio.of_medians)),
            ratio(|ratio| ratio.in_words().into()),
        ];
        row.extend(
            counted.then(|| cell.pair_tests_per_step.map_or_else(String::new, three_digits)),
        );
        row.extend(published.then(|| match cell.report_ms_per_step {
            Some(Report::Seconds(ms)) => three_digits(ms),
            Some(Report::Crashes) => "crashes".into(),
            None => String::new(),
        }));
        table.row(row);
    }
    table
}

/// The shortest takes against what varies, with the report's dashed.
fn chart(axis: &Axis, runs: &[Run]) -> Chart {
    let mut names: Vec<&str> = Vec::new();
    for run in runs {
        if !names.contains(&&*run.variant) {
            names.push(&run.variant);
        }
    }
    let of = |name: &str, y: fn(&Run) -> Option<f64>| -> Vec<(f64, f64)> {
        let runs = runs.iter().filter(|run| run.variant == name);
        runs.filter_map(|run| Some((run.at(axis), y(run)?))).collect()
    };
    // Where its program crashed, there is no number.
    let theirs = |run: &Run| run.report_ms_per_step.as_ref()?.as_f64();
    let reports = names.iter().map(|name| (name, of(name, theirs)));
    let reports = reports.filter(|(_, points)| !points.is_empty());
    let mut at: Vec<f64> = runs.iter().map(|run| run.at(axis)).collect();
    at.sort_by(f64::total_cmp);
    at.dedup();
    let x = match axis {
        Axis::N => chart::Axis::log(axis.label()),
        // There is no half of a thread.
        _ if workers(axis) => chart::Axis::log(axis.label()).with_ticks(at),
        _ => span(axis.label(), at.into_iter()),
    };
    let y = match axis {
        Axis::N => chart::Axis::log("ms a step"),
        _ => span("ms a step".into(), runs.iter().map(|run| run.ms_per_step.min)),
    };
    Chart::new(format!("Time of a step against {axis}"), x, y)
        .with_all(
            names.iter().map(|&n| Series::measured(n, of(n, |run| Some(run.ms_per_step.min)))),
        )
        .with_all(
            reports
                .map(|(name, line)| Series::published(format!("CS3210 report, as {name}"), line)),
        )
}

/// Logarithmic where the values span a decade.
fn span(label: String, values: impl Iterator<Item = f64> + Clone) -> chart::Axis {
    let least = values.clone().fold(f64::INFINITY, f64::min);
    let most = values.fold(0.0, f64::max);
    if least > 0.0 && most >= 10.0 * least {
        chart::Axis::log(label)
    } else {
        chart::Axis::linear(label)
    }
}
