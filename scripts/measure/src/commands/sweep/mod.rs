//! `cargo lab sweep`: variants that take turns while one quantity varies.

mod cell;

use anyhow::Result;
use clap::Args;
use serde::{Deserialize, Serialize};

use crate::chart::{Axis, Chart, Kind, Series, Sheet};
use crate::columns::Columns;
use crate::cs3210::Printed;
use crate::experiment::{Bound, Timing};
use crate::fit::{Effort, Fit};
use crate::job::Job;
use crate::numbers::Files;
use crate::over::{Over, Varied};
use crate::published::HARD_STEPS;
use crate::runner::Runner;
use crate::scene_options::OneScene;
use crate::subject::Subject;
use cell::{Cell, cells};
use lab_kit::table::{Table, three_digits};
use lab_kit::{Kit, Workers};

/// Measure variants while one thing varies: n, the square, the radius, neighbours, threads, a parameter
///
/// 'cargo lab sweep 7 --solution --variant outer-dynamic,planned -t 2 --over radius' takes the
/// values of the CS3210 report; '--over n=1000,10000' takes these values. All runs take turns,
/// round after round. The table shows the shortest take and the median, their ratios to the first
/// variant at the same value, the pairs tested, and the number that the report printed. On a
/// device, '--param timing=1' separates the kernels from the way to the device and back. A run has
/// at most 50 steps, as in the report, unless you set --steps.
#[derive(Args)]
pub struct Options {
    #[command(flatten)]
    subject: Subject,
    /// The varied quantity: n, length, radius, neighbours, threads, ranks or a parameter's name;
    /// optionally with its values
    #[arg(long, value_name = "WHAT[=VALUES]")]
    over: Over,
    #[command(flatten)]
    scene: OneScene,
    /// Number of threads, or ranks
    #[arg(short, default_value_t = 1, value_name = "WORKERS", value_parser = clap::value_parser!(u16).range(1..))]
    t: u16,
    #[command(flatten)]
    effort: Effort,
    #[command(flatten)]
    pub(super) files: Files,
}

#[derive(Serialize)]
struct Results<'r> {
    over: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    device: Option<String>,
    runs: &'r [Cell],
    streaming_bound: &'r [Bound],
}

/// The part of the results that the chart needs.
#[derive(Deserialize)]
pub(super) struct Runs {
    #[serde(default)]
    device: Option<String>,
    runs: Vec<Timing>,
}

impl Options {
    pub(super) fn draw(&self, Runs { device, runs }: Runs) -> Result<Sheet> {
        let varied = &self.over.varied;
        let on = device.map_or_else(String::new, |device| format!(" on {}", short(&device)));
        let title = format!("Time of a step against {varied}{on}");
        Ok(vec![vec![chart(title, varied, &cells(varied, &runs))]])
    }
}

pub(super) fn run(kit: &Kit, options: Options) -> Result<()> {
    let (runner, programs) = options.subject.build(kit, &[], false)?;
    let first = &programs[0];
    let varied = &options.over.varied;
    let values = options.over.values(first)?;
    let scene = options.scene.scene(first.is_hard())?;
    let mut device = None;
    if first.workers == Workers::Device {
        device = Some(device_name(kit, &runner)?);
    }
    let like = Job { workers: options.t.into(), ..Job::new(first.clone(), scene) };
    let fit = Fit::Each { most: HARD_STEPS as u64, affordable: false };
    let timings = options.effort.run(&runner, varied.jobs(&values, &programs, &like), fit)?;
    let cells = cells(varied, &timings.timings);
    println!("{}", table(varied, &cells));
    println!("{}{}", timings.left_out_in_words(), timings.bounds_in_words());
    let streaming_bound = &timings.bounds;
    let results = Results { over: varied.to_string(), device, runs: &cells, streaming_bound };
    options.files.write(results, |shown| options.draw(shown))
}

/// Prints the description of a device, and returns its name. For a software device, the name
/// includes a note that it is not a GPU.
fn device_name(kit: &Kit, runner: &Runner) -> Result<String> {
    let mut cargo = kit.cargo();
    cargo.args(["run", "--release", "--quiet", "--package", "device"]);
    let words = runner.words(&mut cargo, "device")?;
    println!("Device: {words}");
    Ok(words.lines().next().unwrap_or_default().into())
}

/// Shortens a device's name for the title of a chart.
fn short(name: &str) -> String {
    let note = if name.contains("not a GPU") { ", software, not a GPU" } else { "" };
    format!("{}{note}", name.split(" (").next().unwrap_or(name))
}

fn table(varied: &Varied, cells: &[Cell]) -> Table {
    Columns::of(varied.to_string(), |cell: &Cell| cell.at.to_string())
        .text("variant", |cell| cell.variant.clone())
        .times("ms a step: ", |cell| cell.ms_per_step)
        .compared(|cell| cell.timing.times.spread(), |cell| cell.ratio)
        .number("kernels", Cell::kernels)
        .number("way and waiting", Cell::way_and_waiting)
        .number("pair tests a step", |cell| cell.pair_tests_per_step)
        .perhaps("report, ms", |cell| match cell.report_ms_per_step? {
            Printed::Seconds(ms) => Some(three_digits(ms)),
            Printed::Crashes => Some("crashes".into()),
        })
        .table(cells)
}

/// Plots the shortest times against the varied quantity, and the report's numbers as dashed lines.
fn chart(title: String, varied: &Varied, cells: &[Cell]) -> Chart {
    let mut names: Vec<&str> = Vec::new();
    for cell in cells {
        if !names.contains(&&*cell.variant) {
            names.push(&cell.variant);
        }
    }
    let mut chart = Chart::new(title, across(varied, cells), upwards(varied, cells));
    for name in &names {
        let cells = cells.iter().filter(|cell| cell.variant == *name);
        let line = cells.map(|cell| (cell.at, cell.ms_per_step.min)).collect();
        chart = chart.with(Series::new(Kind::Measured, *name, line));
    }
    for name in &names {
        let cells = cells.iter().filter(|cell| cell.variant == *name);
        let line: Vec<_> = cells.filter_map(|cell| Some((cell.at, cell.report_ms()?))).collect();
        if !line.is_empty() {
            let name = format!("CS3210 report, as {name}");
            chart = chart.with(Series::new(Kind::Published, name, line));
        }
    }
    chart
}

fn across(varied: &Varied, cells: &[Cell]) -> Axis {
    let at = cells.iter().map(|cell| cell.at);
    match varied {
        Varied::N => Axis::log(varied.label()),
        // Numbers of workers are integers, so only the measured values have labels.
        _ if varied.is_workers() || varied.is_workgroup() => {
            Axis::log(varied.label()).with_ticks(at)
        }
        _ => span(varied.label(), at),
    }
}

fn upwards(varied: &Varied, cells: &[Cell]) -> Axis {
    match varied {
        Varied::N => Axis::log("ms a step"),
        // These times differ by less than a factor of ten.
        _ if varied.is_workgroup() => Axis::linear("ms a step").starting_at(0.0),
        _ => {
            let ours = cells.iter().map(|cell| cell.ms_per_step.min);
            span("ms a step".into(), ours.chain(cells.iter().filter_map(Cell::report_ms)))
        }
    }
}

/// Makes an axis that is logarithmic if the values span a factor of ten.
fn span(label: String, values: impl Iterator<Item = f64> + Clone) -> Axis {
    let least = values.clone().fold(f64::INFINITY, f64::min);
    let most = values.fold(0.0, f64::max);
    if least > 0.0 && most >= 10.0 * least { Axis::log(label) } else { Axis::linear(label) }
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
