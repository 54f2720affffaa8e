//! The tables, the record and the charts of a device.

use serde::Serialize;

use super::Point;
use super::about::Device;
use crate::chart::{Axis, Chart, Series};
use crate::experiment::{Bound, Record, Records};
use crate::published::{HARD_STEPS, growth};
use lab_kit::program::Program;
use lab_kit::table::{Table, three_digits};

/// Where the time of a step goes, in ms.
#[derive(Serialize)]
struct Split {
    /// All of it, by the host's clock: the shortest take and the median.
    min: f64,
    median: f64,
    /// Kernels, by the device's clock.
    kernels: Option<f64>,
    /// Writing commands down, copying, waiting: what is neither kernel nor host.
    #[serde(rename = "way_and_waiting")]
    way: Option<f64>,
    /// What the host computes itself, in hard discs.
    host: Option<f64>,
    /// Bringing the scene there, once, where it stays there.
    #[serde(skip)]
    loading: Option<f64>,
    /// Nanoseconds of kernels for a pair of hard discs, or for a soft one.
    #[serde(skip)]
    each: Option<f64>,
}

impl Split {
    fn of(point: &Point, record: &Record) -> Self {
        let hard = point.program.is_hard();
        let crate::clock::Span { min, median } = record.ms();
        let counted = |name: &str| record.counters.get(name).copied();
        let ms = |name: &str| record.per_step(name).map(|seconds| seconds * 1e3);
        let kernels = ms("kernel time [s]");
        let transfer = ms("transfer time [s]");
        let way = kernels.and_then(|k| if hard { transfer } else { Some((min - k).max(0.0)) });
        let n = point.n as f64;
        let all = if hard { n * (n - 1.0) / 2.0 } else { n };
        Self {
            min,
            median,
            kernels,
            way,
            host: way.filter(|_| hard).map(|way| (min - kernels.unwrap_or(0.0) - way).max(0.0)),
            loading: counted("transfer time [s]").filter(|_| !hard).map(|s| s * 1e3),
            each: kernels.map(|k| k * 1e6 / all),
        }
    }
}

/// A table for each program.
pub(super) fn print(device: &Device, points: &[Point]) {
    let mut programs: Vec<_> = points.iter().map(|p| &p.program).collect();
    programs.dedup();
    for program in programs {
        let hard = program.is_hard();
        println!("{program} on {}\n", device.name);
        let last = if hard { "host" } else { "loading, once" };
        let each = if hard { "kernel ns a pair" } else { "kernel ns a particle" };
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
        let mut missing = String::new();
        for point in points.iter().filter(|p| p.program == *program) {
            match &point.result {
                Err(why) => {
                    missing += &format!("n = {}, workgroup {}: {why}\n", point.n, point.workgroup);
                }
                Ok(record) => {
                    let split = Split::of(point, record);
                    let number = |value: Option<f64>| value.map_or(String::new(), three_digits);
                    let last = if hard { split.host } else { split.loading };
                    let names = [point.n.to_string(), point.workgroup.to_string()];
                    let times = [Some(split.min), Some(split.median), split.kernels, split.way];
                    table.row(
                        names
                            .into_iter()
                            .chain(times.into_iter().chain([last, split.each]).map(number)),
                    );
                }
            }
        }
        println!("{table}{missing}");
    }
    if device.software {
        println!(
            "These are times of the host's processor, which plays the device: they say what a \
             launch costs here, and nothing about a GPU."
        );
    }
}

/// All numbers.
#[derive(Serialize)]
pub(super) struct Results<'r> {
    device: &'r Device,
    runs: Vec<Run<'r>>,
    streaming_bound: &'r [Bound],
}

#[derive(Serialize)]
struct Run<'r> {
    n: usize,
    workgroup: u32,
    #[serde(flatten)]
    result: Measured<'r>,
}

#[derive(Serialize)]
#[serde(untagged)]
enum Measured<'r> {
    Not {
        program: &'r Program,
        not_measured: &'r str,
    },
    Record {
        #[serde(flatten)]
        record: &'r Record,
        loading_ms: Option<f64>,
        kernel_ns_each: Option<f64>,
        ms_per_step: Split,
    },
}

pub(super) fn results<'r>(
    device: &'r Device,
    points: &'r [Point],
    records: &'r Records,
) -> Results<'r> {
    let run = |point: &'r Point| {
        let result = match &point.result {
            Ok(record) => {
                let split = Split::of(point, record);
                let (loading_ms, kernel_ns_each) = (split.loading, split.each);
                Measured::Record { record, loading_ms, kernel_ns_each, ms_per_step: split }
            }
            Err(why) => Measured::Not { program: &point.program, not_measured: why },
        };
        Run { n: point.n, workgroup: point.workgroup, result }
    };
    Results { device, runs: points.iter().map(run).collect(), streaming_bound: &records.bounds }
}

/// Time against n and against the workgroup, hard and soft discs apart.
pub(super) fn charts(device: &Device, points: &[Point]) -> Vec<Chart> {
    let mut charts = Vec::new();
    for hard in [true, false] {
        let kind = if hard { "Hard discs" } else { "Soft discs" };
        let of_kind: Vec<&Point> = points.iter().filter(|p| p.program.is_hard() == hard).collect();
        let against = |x: fn(&Point) -> f64, varied: &dyn Fn(&Point, &Point) -> bool| {
            let mut lines: Vec<(String, Vec<(f64, f64)>)> = Vec::new();
            for point in &of_kind {
                let partners = of_kind.iter().filter(|q| q.program == point.program);
                let in_line = partners.filter(|q| varied(point, q)).count() > 1;
                if let (Ok(record), true) = (&point.result, in_line) {
                    let name = point.program.variant.clone().unwrap_or_default();
                    let place = (x(point), Split::of(point, record).min);
                    match lines.iter_mut().find(|(known, _)| *known == name) {
                        Some((_, line)) => line.push(place),
                        None => lines.push((name, vec![place])),
                    }
                }
            }
            lines.into_iter().map(|(name, line)| Series::measured(name, line)).collect::<Vec<_>>()
        };
        let usual = |p: &Point| p.workgroup == usual_workgroup(&of_kind, p);
        let over_n = against(|p| p.n as f64, &|p, q| usual(p) && usual(q));
        if !over_n.is_empty() {
            let title = format!("{kind} on {}", device.short());
            let x = Axis::log("discs or particles n");
            let mut chart = Chart::new(title, x, Axis::log("ms a step")).with_all(over_n);
            if hard && !device.software {
                let report = growth("cs3210-cuda-growth");
                let line = report
                    .points
                    .iter()
                    .map(|&(n, seconds)| (n, seconds * 1e3 / HARD_STEPS))
                    .collect();
                chart = chart.with(Series::published(&report.name, line));
            }
            charts.push(chart);
        }
        let over_workgroups = against(|p| f64::from(p.workgroup), &|p, q| p.n == q.n);
        if !over_workgroups.is_empty() {
            let title = format!("{kind}: workgroups on {}", device.short());
            let mut ticks: Vec<f64> = of_kind.iter().map(|p| f64::from(p.workgroup)).collect();
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

/// The workgroup that a program has at most of its n.
fn usual_workgroup(points: &[&Point], of: &Point) -> u32 {
    let own = || points.iter().filter(|p| p.program == of.program);
    let count = |w: u32| own().filter(|p| p.workgroup == w).count();
    own().map(|p| p.workgroup).max_by_key(|&w| count(w)).unwrap_or(of.workgroup)
}
