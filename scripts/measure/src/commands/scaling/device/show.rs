//! The tables and the charts of a device.

use serde::Serialize;

use super::Point;
use super::about::Device;
use crate::chart::{Axis, Chart, Series};
use crate::clock::Span;
use crate::experiment::Record;
use crate::published::{HARD_STEPS, growth};
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

/// Time against n and against the workgroup, hard and soft discs apart.
pub(super) fn charts(device: &Device, points: &[Point]) -> Vec<Chart> {
    let mut charts = Vec::new();
    for (hard, kind) in [(true, "Hard discs"), (false, "Soft discs")] {
        let against = |x: fn(&Point) -> Option<f64>| -> Vec<Series> {
            let of_kind = points.iter().filter(|point| point.program.is_hard() == hard);
            let of_kind: Vec<&Point> = of_kind.filter(|p| x(p).is_some()).collect();
            let line = |points: &[&Point]| {
                let place = |p: &&Point| Some((x(p)?, p.split.as_ref()?.ms_per_step.all.min));
                let name = points[0].program.variant.clone().unwrap_or_default();
                Series::measured(name, points.iter().filter_map(place).collect())
            };
            of_kind.chunk_by(|a, b| a.program == b.program).map(line).collect()
        };
        let over_n = against(|point| point.over.0.then_some(point.n as f64));
        if !over_n.is_empty() {
            let title = format!("{kind} on {}", device.short());
            let x = Axis::log("discs or particles n");
            let mut chart = Chart::new(title, x, Axis::log("ms a step")).with_all(over_n);
            if hard && !device.software {
                let report = growth("cs3210-cuda-growth");
                let ms = |&(n, seconds): &(f64, f64)| (n, seconds * 1e3 / HARD_STEPS);
                let line = report.points.iter().map(ms).collect();
                chart = chart.with(Series::published(&report.name, line));
            }
            charts.push(chart);
        }
        let over_workgroups = against(|point| point.over.1.then_some(f64::from(point.workgroup)));
        if !over_workgroups.is_empty() {
            let title = format!("{kind}: workgroups on {}", device.short());
            let mut ticks: Vec<f64> = points.iter().map(|p| f64::from(p.workgroup)).collect();
            ticks.sort_by(f64::total_cmp);
            ticks.dedup();
            let x = Axis::log("threads of a workgroup").with_ticks(ticks);
            // They differ by less than a decade.
            let y = Axis::linear("ms a step").starting_at(0.0);
            charts.push(Chart::new(title, x, y).with_all(over_workgroups));
        }
    }
    charts
}
