//! The tables and the charts of a device.

use std::fmt::Write;

use serde::Serialize;

use super::{Point, Results};
use crate::chart::{Axis, Chart, Series, Sheet};
use crate::clock::Span;
use crate::columns::Columns;
use crate::experiment::Record;
use crate::published::{HARD_STEPS, growth};

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
    pub(super) fn of(record: &Record) -> Self {
        let (job, all) = (&record.job, record.ms());
        let (n, hard) = (job.scene.n() as f64, job.program.is_hard());
        let ms = |name: &str| record.per_step(name).map(|seconds| seconds * 1e3);
        let (kernels, transfer) = (ms("kernel time [s]"), ms("transfer time [s]"));
        let way = kernels.and_then(|k| if hard { transfer } else { Some((all.min - k).max(0.0)) });
        let rest = |way: f64| (all.min - kernels.unwrap_or(0.0) - way).max(0.0);
        let each = if hard { n * (n - 1.0) / 2.0 } else { n };
        Self {
            ms_per_step: Parts {
                all,
                kernels,
                way_and_waiting: way,
                host: way.filter(|_| hard).map(rest),
            },
            loading_ms: transfer.filter(|_| !hard).map(|ms| ms * job.steps as f64),
            kernel_ns_each: kernels.map(|ms| ms * 1e6 / each),
        }
    }
}

/// The table of a program, and below it what was not measured.
pub(super) fn table(points: &[Point], hard: bool) -> String {
    let (last, each) = match hard {
        true => ("host", "kernel ns a pair"),
        false => ("loading, once", "kernel ns a particle"),
    };
    let split = |point: &Point, of: fn(&Split) -> Option<f64>| of(point.split.as_ref()?);
    let table = Columns::of("n", |point: &Point| point.n.to_string())
        .text("workgroup", |point| point.workgroup.to_string())
        .number("ms a step: min", |point| split(point, |s| Some(s.ms_per_step.all.min)))
        .number("median", |point| split(point, |s| Some(s.ms_per_step.all.median)))
        .number("kernels", |point| split(point, |s| s.ms_per_step.kernels))
        .number("way and waiting", |point| split(point, |s| s.ms_per_step.way_and_waiting))
        .number(last, |point| split(point, |s| s.ms_per_step.host.or(s.loading_ms)))
        .number(each, |point| split(point, |s| s.kernel_ns_each))
        .table(points.iter().filter(|point| point.split.is_some()));
    let mut text = table.to_string();
    for Point { n, workgroup, not_measured, .. } in points {
        if let Some(why) = not_measured {
            let _ = write!(text, "\nn = {n}, workgroup {workgroup}: {why}");
        }
    }
    text
}

impl Results {
    /// Time against n and against the workgroup, hard and soft discs apart.
    pub(in super::super) fn draw(&self) -> Sheet {
        let device = short(&self.device.name, self.device.software);
        let mut sheet = Vec::new();
        for (hard, kind) in [(true, "Hard discs"), (false, "Soft discs")] {
            let over_n = self.lines(hard, |point| point.n, |point| point.workgroup as usize);
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
            let over_workgroups =
                self.lines(hard, |point| point.workgroup as usize, |point| point.n);
            if !over_workgroups.is_empty() {
                let title = format!("{kind}: workgroups on {device}");
                let ran = self.runs.iter().filter(|point| point.record.is_some());
                let ticks = ran.map(|point| f64::from(point.workgroup));
                let x = Axis::log("threads of a workgroup").with_ticks(ticks);
                // They differ by less than a decade.
                let y = Axis::linear("ms a step").starting_at(0.0);
                sheet.push(vec![Chart::new(title, x, y).with_all(over_workgroups)]);
            }
        }
        sheet
    }

    /// A line for each program, through the runs that have `fixed` in common with another.
    fn lines(&self, hard: bool, x: fn(&Point) -> usize, fixed: fn(&Point) -> usize) -> Vec<Series> {
        let runs = self.runs.iter().filter_map(|point| Some((point, point.record.as_ref()?)));
        let runs: Vec<_> = runs.filter(|(_, run)| run.job.program.is_hard() == hard).collect();
        let varies = |(point, run): &&(&Point, &Record)| {
            runs.iter().any(|(other, another)| {
                let alike = another.job.is_like(&run.job) && fixed(other) == fixed(point);
                alike && x(other) != x(point)
            })
        };
        let varied: Vec<_> = runs.iter().filter(varies).collect();
        let line = |runs: &[&(&Point, &Record)]| {
            let points = runs.iter().map(|(point, run)| (x(point) as f64, run.ms().min)).collect();
            Series::measured(runs[0].1.job.program.variant.clone().unwrap_or_default(), points)
        };
        varied.chunk_by(|a, b| a.1.job.is_like(&b.1.job)).map(line).collect()
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
