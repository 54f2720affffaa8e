//! The tables, the record and the charts of a device.

use serde_json::{Value, json};

use super::Point;
use super::about::Device;
use crate::chart::{Axis, Chart, Series};
use crate::published::{HARD_STEPS, growth};
use crate::rounds::{Measured, Rounds};
use lab_kit::table::{Table, three_digits};

/// Where the time of a step goes, in ms.
struct Split {
    /// All of it, by the host's clock: the shortest take and the median.
    min: f64,
    median: f64,
    /// Kernels, by the device's clock.
    kernels: Option<f64>,
    /// Writing commands down, copying, waiting: what is neither kernel nor host.
    way: Option<f64>,
    /// What the host computes itself, in hard discs.
    host: Option<f64>,
    /// Bringing the scene there, once, where it stays there.
    loading: Option<f64>,
    /// Nanoseconds of kernels for a pair of hard discs, or for a soft one.
    each: Option<f64>,
}

impl Split {
    fn of(point: &Point, measured: &Measured) -> Self {
        let hard = point.program.is_hard();
        let per_step = 1e3 / measured.job.steps as f64;
        let counted = |name: &str| measured.counters.get(name).copied();
        let ms = |name: &str| counted(name).map(|seconds| seconds * per_step);
        let min = measured.times.min() * per_step;
        let kernels = ms("kernel time [s]");
        let transfer = ms("transfer time [s]");
        let way = kernels.and_then(|k| if hard { transfer } else { Some((min - k).max(0.0)) });
        let n = point.n as f64;
        let all = if hard { n * (n - 1.0) / 2.0 } else { n };
        Self {
            min,
            median: measured.times.median() * per_step,
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
            "",
        ]);
        for point in points.iter().filter(|p| p.program == *program) {
            let mut row = vec![point.n.to_string(), point.workgroup.to_string()];
            match &point.result {
                Err(why) => {
                    row.extend([const { String::new() }; 6].into_iter().chain([why.clone()]))
                }
                Ok(measured) => {
                    let split = Split::of(point, measured);
                    let number = |value: Option<f64>| value.map_or(String::new(), three_digits);
                    row.extend([three_digits(split.min), three_digits(split.median)]);
                    let last = if hard { split.host } else { split.loading };
                    row.extend([split.kernels, split.way, last, split.each].map(number));
                }
            }
            table.row(row);
        }
        println!("{table}");
    }
    if device.software {
        println!(
            "These are times of the host's processor, which plays the device: they say what a \
             launch costs here, and nothing about a GPU."
        );
    }
}

/// All numbers.
pub(super) fn results(device: &Device, points: &[Point], rounds: &Rounds) -> Value {
    let run = |point: &Point| {
        let mut row = match &point.result {
            Ok(measured) => measured.as_json(),
            Err(why) => json!({ "not_measured": why }),
        };
        row["program"] = json!(point.program.to_string());
        row["n"] = json!(point.n);
        row["workgroup"] = json!(point.workgroup);
        if let Ok(measured) = &point.result {
            let split = Split::of(point, measured);
            row["ms_per_step"] = json!({
                "min": split.min, "median": split.median, "kernels": split.kernels,
                "way_and_waiting": split.way, "host": split.host,
            });
            row["loading_ms"] = json!(split.loading);
            row["kernel_ns_each"] = json!(split.each);
        }
        row
    };
    json!({
        "device": device.as_json(),
        "runs": points.iter().map(run).collect::<Vec<_>>(),
        "streaming_bound": rounds.bounds,
    })
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
                if let (Ok(measured), true) = (&point.result, in_line) {
                    let name = point.program.variant.clone().unwrap_or_default();
                    let place = (x(point), Split::of(point, measured).min);
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
