//! The tables and the charts of a device.

use serde::{Deserialize, Serialize};

use super::Point;
use super::about::Device;
use crate::chart::{Axis, Chart, Series, Sheet};
use crate::clock::Span;
use crate::experiment::Record;
use crate::published::{HARD_STEPS, growth};
use lab_kit::program::Program;
use lab_kit::table::{Table, three_digits};

/// Where the time of a step goes.
#[derive(Serialize)]
pub(super) struct Split {
    ms_per_step: Parts,
    /// Bringing the scene there, once, where it stays there.
    loading_ms: Option<f64>,
    /// Kernels, for a pair of hard discs or for a soft one.
    kernel_ns_each: Option<f64>,
}

#[derive(Serialize)]
struct Parts {
    /// All of it, by the host's clock.
    #[serde(flatten)]
    all: Span,
    /// Kernels, by the device's clock.
    kernels: Option<f64>,
    /// Writing commands down, copying, waiting: what is neither kernel nor host.
    way_and_waiting: Option<f64>,
    /// What the host computes itself, in hard discs.
    host: Option<f64>,
}

impl Split {
    pub(super) fn of(point: &Point, record: &Record) -> Self {
        let (n, hard, all) = (point.n as f64, point.program.is_hard(), record.ms());
        let ms = |name: &str| record.per_step(name).map(|seconds| seconds * 1e3);
        let (kernels, transfer) = (ms("kernel time [s]"), ms("transfer time [s]"));
        let way = kernels.and_then(|k| if hard { transfer } else { Some((all.min - k).max(0.0)) });
        let rest = |way: f64| (all.min - kernels.unwrap_or(0.0) - way).max(0.0);
        let each = if hard { n * (n - 1.0) / 2.0 } else { n };
        let steps = record.job.steps as f64;
        Self {
            ms_per_step: Parts {
                all,
                kernels,
                way_and_waiting: way,
                host: way.filter(|_| hard).map(rest),
            },
            loading_ms: transfer.filter(|_| !hard).map(|ms| ms * steps),
            kernel_ns_each: kernels.map(|ms| ms * 1e6 / each),
        }
    }
}

/// A table for each program.
pub(super) fn print(device: &Device, points: &[Point]) {
    for points in points.chunk_by(|a, b| a.program == b.program) {
        let program = &points[0].program;
        println!("{program} on {}\n", device.name);
        let (last, each) = match program.is_hard() {
            true => ("host", "kernel ns a pair"),
            false => ("loading, once", "kernel ns a particle"),
        };
        let mut table = Table::new([
            "n",
            "workgroup",
            "ms a step: min",
            "median",
            "kernels",
            "way and waiting",
            last,
            each,
        ]);
        for Point { n, workgroup, split, .. } in points {
            let Some(Split { ms_per_step: ms, loading_ms, kernel_ns_each }) = split else {
                continue;
            };
            let (min, median, last) =
                (Some(ms.all.min), Some(ms.all.median), ms.host.or(*loading_ms));
            let times = [min, median, ms.kernels, ms.way_and_waiting, last, *kernel_ns_each];
            let times = times.map(|time| time.map_or_else(String::new, three_digits));
            table.row([n.to_string(), workgroup.to_string()].into_iter().chain(times));
        }
        println!("{table}");
        for Point { n, workgroup, not_measured, .. } in points {
            if let Some(why) = not_measured {
                println!("n = {n}, workgroup {workgroup}: {why}");
            }
        }
    }
    if device.software {
        println!(
            "These are times of the host's processor, which plays the device: they say what a\n\
             launch costs here, and nothing about a GPU."
        );
    }
}

/// What the figure shows of the results.
#[derive(Deserialize)]
pub struct Runs {
    device: About,
    runs: Vec<Run>,
}

#[derive(Deserialize)]
struct About {
    name: String,
    software: bool,
}

/// A program at one n and one size of workgroup; no program where none could run.
#[derive(Deserialize)]
struct Run {
    program: Option<Program>,
    n: usize,
    workgroup: u32,
    ms_per_step: Option<Span>,
}

impl Runs {
    /// Time against n and against the workgroup, hard and soft discs apart.
    pub(in super::super) fn draw(&self) -> Sheet {
        let device = short(&self.device.name, self.device.software);
        let mut sheet = Vec::new();
        for (hard, kind) in [(true, "Hard discs"), (false, "Soft discs")] {
            let over_n = self.lines(hard, |run| run.n as f64, |run| run.workgroup as usize);
            if !over_n.is_empty() {
                let x = Axis::log("discs or particles n");
                let title = format!("{kind} on {device}");
                let mut chart = Chart::new(title, x, Axis::log("ms a step")).with_all(over_n);
                if hard && !self.device.software {
                    let report = growth("cs3210-cuda-growth");
                    let ms = |&(n, seconds): &(f64, f64)| (n, seconds * 1e3 / HARD_STEPS);
                    let line = report.points.iter().map(ms).collect();
                    chart = chart.with(Series::published(&report.name, line));
                }
                sheet.push(vec![chart]);
            }
            let over_workgroups = self.lines(hard, |run| f64::from(run.workgroup), |run| run.n);
            if !over_workgroups.is_empty() {
                let title = format!("{kind}: workgroups on {device}");
                let mut ticks: Vec<f64> =
                    self.runs.iter().map(|run| f64::from(run.workgroup)).collect();
                ticks.sort_by(f64::total_cmp);
                ticks.dedup();
                let x = Axis::log("threads of a workgroup").with_ticks(ticks);
                // They differ by less than a decade.
                let y = Axis::linear("ms a step").starting_at(0.0);
                sheet.push(vec![Chart::new(title, x, y).with_all(over_workgroups)]);
            }
        }
        sheet
    }

    /// A line for each program, through the runs that have `fixed` in common with another.
    fn lines(&self, hard: bool, x: fn(&Run) -> f64, fixed: fn(&Run) -> usize) -> Vec<Series> {
        let mut runs: Vec<(&Program, &Run, f64)> = Vec::new();
        for run in &self.runs {
            if let (Some(program), Some(ms)) = (&run.program, run.ms_per_step) {
                runs.push((program, run, ms.min));
            }
        }
        let varies = |&&(program, run, _): &&(&Program, &Run, f64)| {
            let other = |&(another, other, _): &(&Program, &Run, f64)| {
                another == program && fixed(other) == fixed(run) && x(other) != x(run)
            };
            program.is_hard() == hard && runs.iter().any(other)
        };
        let varied: Vec<_> = runs.iter().filter(varies).collect();
        let line = |runs: &[&(&Program, &Run, f64)]| {
            let points = runs.iter().map(|&&(_, run, ms)| (x(run), ms)).collect();
            Series::measured(runs[0].0.variant.clone().unwrap_or_default(), points)
        };
        varied.chunk_by(|a, b| a.0 == b.0).map(line).collect()
    }
}

/// A device's name for the titles of charts.
fn short(name: &str, software: bool) -> String {
    let name = name.split(" (").next().unwrap_or(name);
    if software { format!("{name}, software, not a GPU") } else { name.into() }
}

#[cfg(test)]
mod tests {
    use super::short;

    #[test]
    fn software_is_no_gpu() {
        assert_eq!(short("llvmpipe (LLVM 15, 256 bits)", true), "llvmpipe, software, not a GPU");
        assert_eq!(short("NVIDIA H200", false), "NVIDIA H200");
    }
}
