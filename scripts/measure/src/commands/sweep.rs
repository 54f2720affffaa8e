//! `cargo lab sweep`: variants side by side while one thing varies.

use std::collections::BTreeMap;
use std::process::ExitCode;

use anyhow::Result;
use clap::Args;
use serde::{Deserialize, Serialize};

use crate::axis::{Axis, Over};
use crate::chart::{self, Chart, Kind, Series, Sheet};
use crate::clock::{Ratio, Span};
use crate::columns::Columns;
use crate::experiment::{Bound, Record};
use crate::files::Files;
use crate::fit::{Effort, Fit};
use crate::job::Job;
use crate::published::{self, HARD_STEPS, Report};
use crate::runner::Runner;
use crate::scene::{OneScene, Random, Scene};
use crate::subject::Subject;
use lab_kit::table::{Table, three_digits};
use lab_kit::{Kit, Workers};

/// Measure variants while one thing varies: n, the square, the radius, neighbours, threads, a parameter
///
/// 'cargo lab sweep 7 --solution --variant outer-dynamic,planned -t 2 --over radius' takes the
/// values of the CS3210 report; '--over n=1000,10000' takes these. All runs take turns, round after
/// round. Shown are the shortest take and the median, how both compare with the first variant's at
/// the same value, the pairs looked at, and what the report printed. On a device, with '--param timing=1', kernels
/// are shown apart from the way to the device and back.
/// A run has at most 50 steps, as in the report, unless --steps says otherwise.
#[derive(Args)]
pub struct Options {
    #[command(flatten)]
    subject: Subject,
    /// What varies: n, length, radius, neighbours, threads, ranks or a parameter's name; perhaps with
    /// its values
    #[arg(long, value_name = "WHAT[=VALUES]")]
    over: Over,
    #[command(flatten)]
    scene: OneScene,
    /// Threads, or ranks
    #[arg(short, default_value_t = 1, value_name = "WORKERS", value_parser = clap::value_parser!(u16).range(1..))]
    t: u16,
    #[command(flatten)]
    effort: Effort,
    #[command(flatten)]
    pub(super) files: Files,
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
    #[serde(skip_serializing_if = "Option::is_none")]
    device: Option<String>,
    runs: &'r [Cell],
    streaming_bound: &'r [Bound],
}

/// What the figure shows of the results.
#[derive(Deserialize)]
pub struct Runs {
    #[serde(default)]
    device: Option<String>,
    runs: Vec<Record>,
}

impl Options {
    pub(super) fn draw(&self, Runs { device, runs }: Runs) -> Result<Sheet> {
        let axis = &self.over.axis;
        let on = device.map_or_else(String::new, |device| format!(" on {}", short(&device)));
        let title = format!("Time of a step against {axis}{on}");
        Ok(vec![vec![chart(title, axis, &cells(axis, &runs))]])
    }
}

/// Measures, prints, writes.
pub fn run(kit: &Kit, options: Options) -> Result<ExitCode> {
    let (runner, programs) = options.subject.build(kit, &[], false)?;
    let (axis, values) = (&options.over.axis, options.over.values(&programs[0])?);
    let scene = options.scene.scene(programs[0].is_hard())?;
    let on_device = programs[0].workers == Workers::Device;
    let device = on_device.then(|| device(kit, &runner)).transpose()?;
    let like = Job { workers: options.t.into(), ..Job::new(programs[0].clone(), scene) };
    let jobs = axis.jobs(&values, &programs, &like);
    let fit = Fit::Each { most: HARD_STEPS as u64, affordable: false };
    let records = options.effort.run(&runner, jobs, fit)?;
    let cells = cells(axis, &records.records);
    println!(
        "{}\n{}{}",
        table(axis, &cells),
        records.left_out_in_words(),
        records.bounds_in_words()
    );
    let (over, streaming_bound) = (axis.to_string(), &records.bounds[..]);
    options.files.write(Results { over, device, runs: &cells, streaming_bound }, |shown| {
        options.draw(shown)
    })?;
    Ok(ExitCode::SUCCESS)
}

/// Prints what a device says of itself, and returns its name; that of software says that it is no GPU.
fn device(kit: &Kit, runner: &Runner) -> Result<String> {
    let mut cargo = kit.cargo();
    cargo.args(["run", "--release", "--quiet", "--package", "device"]);
    let words = runner.words(&mut cargo, "device")?;
    println!("Device: {words}");
    Ok(words.lines().next().unwrap_or_default().into())
}

/// A device's name for the title of a chart.
fn short(name: &str) -> String {
    let note = if name.contains("not a GPU") { ", software, not a GPU" } else { "" };
    format!("{}{note}", name.split(" (").next().unwrap_or(name))
}

/// The variants at each value, each beside the first.
fn cells(axis: &Axis, records: &[Record]) -> Vec<Cell> {
    let at = |record: &Record| axis.of(&record.job);
    let rows = records.chunk_by(|a, b| at(a) == at(b));
    rows.flat_map(|row| row.iter().map(|record| Cell::new(axis, record, &row[0]))).collect()
}

impl Cell {
    fn new(axis: &Axis, record: &Record, first: &Record) -> Self {
        let (at, program) = (axis.of(&record.job), &record.job.program);
        let is_first = std::ptr::eq(record, first);
        Self {
            at,
            value: (!axis.is_workers()).then(|| BTreeMap::from([(axis.to_string(), at)])),
            variant: program.variant.clone().unwrap_or_else(|| program.package()),
            ms_per_step: record.ms(),
            pair_tests_per_step: record.per_step("pair tests"),
            report_ms_per_step: report(axis, at, record),
            ratio: (!is_first).then(|| record.ms().over(first.ms())),
            record: record.clone(),
        }
    }
}

/// What the CS3210 report has for the same program on the same scene, on its own machine: ms a step.
fn report(axis: &Axis, value: f64, record: &Record) -> Option<Report> {
    let Scene::Hard { n, side, radius, random } = record.job.scene else { return None };
    if random != Random::default() || axis.is_workgroup() {
        return None;
    }
    let program = &record.job.program;
    let workers = axis.is_workers().then_some(value as usize);
    let variant = program.variant.as_deref()?;
    let report = published::hard_discs(program.workers, variant, (n, side, radius), workers)?;
    Some(report.scaled(1e3 / HARD_STEPS))
}

fn table(axis: &Axis, cells: &[Cell]) -> Table {
    let theirs = |cell: &Cell| match cell.report_ms_per_step? {
        Report::Seconds(ms) => Some(three_digits(ms)),
        Report::Crashes => Some("crashes".into()),
    };
    Columns::of(axis.to_string(), |cell: &Cell| cell.at.to_string())
        .text("variant", |cell| cell.variant.clone())
        .times("ms a step: ", |cell| cell.ms_per_step)
        .compared(|cell| (cell.record.times.spread(), cell.ratio))
        .number("kernels", kernels)
        .number("way and waiting", way_and_waiting)
        .number("pair tests a step", |cell| cell.pair_tests_per_step)
        .perhaps("report, ms", theirs)
        .table(cells)
}

/// Milliseconds of a step that are spent on a device and not in its kernels: writing commands down, copying, waiting.
/// Soft discs stay there, so that is all the rest; the host of hard discs computes, too.
fn way_and_waiting(cell: &Cell) -> Option<f64> {
    let kernels = kernels(cell)?;
    match cell.record.job.program.is_hard() {
        true => cell.record.per_step("transfer time [s]").map(|seconds| 1e3 * seconds),
        false => Some((cell.ms_per_step.min - kernels).max(0.0)),
    }
}

/// Milliseconds of a step in kernels, by the device's clock.
fn kernels(cell: &Cell) -> Option<f64> {
    cell.record.per_step("kernel time [s]").map(|seconds| 1e3 * seconds)
}

/// The shortest takes against what varies, with the report's dashed.
fn chart(title: String, axis: &Axis, cells: &[Cell]) -> Chart {
    let mut names: Vec<&str> = Vec::new();
    for cell in cells {
        if !names.contains(&&*cell.variant) {
            names.push(&cell.variant);
        }
    }
    let of = |name: &str, y: fn(&Cell) -> Option<f64>| -> Vec<(f64, f64)> {
        let cells = cells.iter().filter(|cell| cell.variant == name);
        cells.filter_map(|cell| Some((cell.at, y(cell)?))).collect()
    };
    let ours = |&name: &&str| {
        Series::new(Kind::Measured, name, of(name, |cell| Some(cell.ms_per_step.min)))
    };
    let theirs = |name: &&str| {
        let line = of(name, report_ms);
        let there = !line.is_empty();
        there.then(|| Series::new(Kind::Published, format!("CS3210 report, as {name}"), line))
    };
    let at = cells.iter().map(|cell| cell.at);
    let x = match axis {
        Axis::N => chart::Axis::log(axis.label()),
        // There is no half of a thread.
        _ if axis.is_workers() || axis.is_workgroup() => {
            chart::Axis::log(axis.label()).with_ticks(at)
        }
        _ => span(axis.label(), at),
    };
    let y = match axis {
        Axis::N => chart::Axis::log("ms a step"),
        // They differ by less than a decade.
        _ if axis.is_workgroup() => chart::Axis::linear("ms a step").starting_at(0.0),
        _ => {
            let ours = cells.iter().map(|cell| cell.ms_per_step.min);
            span("ms a step".into(), ours.chain(cells.iter().filter_map(report_ms)))
        }
    };
    Chart::new(title, x, y)
        .with_all(names.iter().map(ours))
        .with_all(names.iter().filter_map(theirs))
}

/// What the report took, where its program did not crash.
fn report_ms(cell: &Cell) -> Option<f64> {
    match cell.report_ms_per_step? {
        Report::Seconds(ms) => Some(ms),
        Report::Crashes => None,
    }
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

#[cfg(test)]
mod tests {
    use super::short;

    #[test]
    fn software_is_no_gpu() {
        let software = "llvmpipe (LLVM 15, 256 bits) (software on the host's processor, not a GPU)";
        assert_eq!(short(software), "llvmpipe, software, not a GPU");
        assert_eq!(short("NVIDIA H200"), "NVIDIA H200");
    }
}
