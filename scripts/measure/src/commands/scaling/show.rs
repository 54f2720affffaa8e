//! The tables, the record and the charts of a scaling measurement.

use std::collections::BTreeSet;

use anyhow::{Result, bail};
use serde_json::{Value, json};

use super::Plan;
use super::curve::{Curve, Point};
use crate::chart::{Axis, Chart, Series};
use crate::published;
use crate::rounds::{Measured, Rounds};
use lab_kit::table::{Table, three_digits};

/// Prints a table for each variant, its grade, and what the runs counted.
pub(super) fn print(plan: &Plan, curves: &[Curve], rounds: &Rounds) {
    for curve in curves {
        println!("{}\n", curve.program);
        if let Some(steps) = curve.strong.first().map(|p| p.measured.job.steps) {
            println!("strong: n = {}, {steps} steps, t1 from {}", plan.n, plan.serial);
        }
        println!("{}", table(&curve.strong, true));
        if let Some(per_worker) = plan.per_worker {
            println!("weak: n = {per_worker} per worker, t1 from {}", plan.serial);
            println!("{}", table(&curve.weak, false));
        }
        println!("{}\n", verdict(curve));
    }
    let counted = counters(curves);
    if !counted.is_empty() {
        println!("What the shortest runs counted\n\n{counted}");
    }
    let serial = rounds.measured.iter().find(|m| m.job.program == plan.serial);
    if let Some(serial) = serial {
        println!(
            "t1 = {} ms a step: {} on one worker, n = {}",
            ms(serial, serial.times.min()),
            plan.serial,
            serial.job.scene.n()
        );
    }
    println!("{}", rounds.bounds_in_words());
    let streaming = rounds.bound(plan.n, false) / rounds.bound(plan.n, true);
    println!("Streaming on all cores is {streaming:.2} times as fast as on one at n = {}.", plan.n);
}

fn table(points: &[Point], strong: bool) -> Table {
    let against = if strong { ["speed-up", "own speed-up"] } else { ["", ""] };
    let mut header =
        vec!["workers", "n", "ms a step: min", "median", "efficiency", "own efficiency"];
    if strong {
        header.extend(against);
    }
    header.push("");
    let mut table = Table::new(header);
    for point in points {
        let (m, p) = (&point.measured, point.workers as f64);
        let mut row = vec![
            point.workers.to_string(),
            m.job.scene.n().to_string(),
            ms(m, m.times.min()),
            ms(m, m.times.median()),
            format!("{:.2}", point.efficiency),
            format!("{:.2}", point.own_efficiency),
        ];
        if strong {
            row.push(format!("{:.2}", p * point.efficiency));
            row.push(format!("{:.2}", p * point.own_efficiency));
        }
        row.push(if point.graded() { "" } else { "oversubscribed, not graded" }.into());
        table.row(row);
    }
    table
}

fn ms(measured: &Measured, seconds: f64) -> String {
    three_digits(seconds * 1e3 / measured.job.steps as f64)
}

fn verdict(curve: &Curve) -> String {
    let Some(verdict) = curve.verdict() else {
        return "No number of workers fits on this machine: no grade.".into();
    };
    let mut text = format!("Average strong efficiency {:.2}", verdict.strong);
    if let Some(weak) = verdict.weak {
        text += &format!(", weak {weak:.2}");
    }
    text += &format!(". Grade: {:.2} of 100.", verdict.grade);
    if (verdict.grade_of_medians - verdict.grade).abs() > 5.0 {
        text += &format!(
            "\nBy the medians it is {:.2}: the times spread too wide to decide. \
             Close other programs and measure again.",
            verdict.grade_of_medians
        );
    }
    text
}

/// A row for each run of the strong scaling that counts anything, a column for each counter.
fn counters(curves: &[Curve]) -> String {
    let points = || curves.iter().flat_map(|c| c.strong.iter().map(move |p| (&c.program, p)));
    let names = counter_names(curves);
    if names.is_empty() {
        return String::new();
    }
    let header = ["program", "workers"].into_iter().chain(names.iter().map(|name| name.as_str()));
    let mut table = Table::new(header);
    for (program, point) in points().filter(|(_, p)| !p.measured.counters.is_empty()) {
        let value = |name: &String| {
            point.measured.counters.get(name).map_or(String::new(), |v| three_digits(*v))
        };
        let cells = [program.to_string(), point.workers.to_string()];
        table.row(cells.into_iter().chain(names.iter().map(value)));
    }
    table.to_string()
}

/// All numbers.
pub(super) fn results(plan: &Plan, curves: &[Curve], rounds: &Rounds) -> Value {
    let points = |points: &[Point]| -> Vec<Value> {
        let row = |point: &Point| {
            let mut row = point.measured.as_json();
            row["workers"] = json!(point.workers);
            row["efficiency"] = json!(point.efficiency);
            row["own_efficiency"] = json!(point.own_efficiency);
            row["graded"] = json!(point.graded());
            row
        };
        points.iter().map(row).collect()
    };
    let curves: Vec<Value> = curves
        .iter()
        .map(|curve| {
            let verdict = curve.verdict();
            json!({
                "program": curve.program.to_string(),
                "strong": points(&curve.strong), "weak": points(&curve.weak),
                "average_strong_efficiency": verdict.as_ref().map(|v| v.strong),
                "average_weak_efficiency": verdict.as_ref().and_then(|v| v.weak),
                "grade": verdict.as_ref().map(|v| v.grade),
            })
        })
        .collect();
    let serial = rounds.measured.iter().filter(|m| m.job.program == plan.serial);
    json!({
        "serial": serial.map(Measured::as_json).collect::<Vec<_>>(),
        "curves": curves, "streaming_bound": rounds.bounds,
    })
}

/// Speed-up, strong efficiency and, where there is one, weak efficiency.
pub(super) fn charts(plan: &Plan, curves: &[Curve]) -> Vec<Chart> {
    let report = match (plan.serial.is_hard(), curves.iter().any(|c| c.program.has_ranks())) {
        (false, false) => published::scaling("csc581-openmp"),
        (false, true) => published::scaling("csc581-mpi"),
        (true, false) => published::scaling("cs3210-openmp"),
        (true, true) => published::scaling("cs3210-mpi"),
    };
    let ours = |points: fn(&Curve) -> &Vec<Point>, value: fn(&Point) -> f64| {
        curves.iter().map(move |curve| {
            let line = points(curve).iter().map(|p| (p.workers as f64, value(p))).collect();
            Series::measured(curve.program.to_string(), line)
        })
    };
    let theirs =
        |values: Vec<f64>| Series::published(&report.name, report.workers().zip(values).collect());
    let workers = plan.workers.iter().map(|&p| p as f64).chain(report.workers());
    let mut ticks: Vec<f64> = workers.collect();
    ticks.sort_by(f64::total_cmp);
    ticks.dedup();
    let ideal = |value: fn(f64) -> f64| {
        Series::guide("ideal", ticks.iter().map(|&p| (p, value(p))).collect())
    };
    let x = || Axis::log("workers").with_ticks(ticks.clone());
    let efficiency = || Axis::linear("efficiency").starting_at(0.0);

    let speed_up = Chart::new(format!("Speed-up over {}", plan.serial), x(), Axis::log("speed-up"))
        .with_all(ours(|c| &c.strong, |p| p.workers as f64 * p.efficiency))
        .with(theirs(report.speedups()))
        .with(ideal(|p| p));
    let strong = Chart::new(format!("Strong scaling, n = {}", plan.n), x(), efficiency())
        .with_all(ours(|c| &c.strong, |p| p.efficiency))
        .with(theirs(report.strong_efficiencies()))
        .with(ideal(|_| 1.0));
    let mut charts = vec![speed_up, strong];
    if let Some(per_worker) = plan.per_worker {
        let title = format!("Weak scaling, n = {per_worker} per worker");
        charts.push(
            Chart::new(title, x(), efficiency())
                .with_all(ours(|c| &c.weak, |p| p.efficiency))
                .with(theirs(report.weak_efficiencies()))
                .with(ideal(|_| 1.0)),
        );
    }
    charts
}

/// What the programs that count it counted, against the workers.
///
/// # Errors
/// No program counts it, or the name fits several counters.
pub(super) fn counter_chart(plan: &Plan, curves: &[Curve], name: &str) -> Result<Chart> {
    let names = counter_names(curves);
    let fitting: Vec<&String> = names.iter().filter(|counter| counter.contains(name)).collect();
    let [counter] = fitting[..] else {
        bail!("'{name}' fits {} of the counters: {}", fitting.len(), names.join("; "));
    };
    let line = |curve: &Curve| -> Vec<(f64, f64)> {
        let point = |p: &Point| Some((p.workers as f64, *p.measured.counters.get(counter)?));
        curve.strong.iter().filter_map(point).collect()
    };
    let lines = curves.iter().map(|curve| (curve.program.to_string(), line(curve)));
    let lines = lines.filter(|(_, line)| !line.is_empty());
    let ticks: Vec<f64> = plan.workers.iter().map(|&p| p as f64).collect();
    let y = Axis::linear(counter.as_str()).starting_at(0.0);
    Ok(Chart::new(format!("Counted, n = {}", plan.n), Axis::log("workers").with_ticks(ticks), y)
        .with_all(lines.map(|(program, line)| Series::measured(program, line))))
}

fn counter_names(curves: &[Curve]) -> Vec<String> {
    let points = curves.iter().flat_map(|curve| &curve.strong);
    let names: BTreeSet<&String> = points.flat_map(|p| p.measured.counters.keys()).collect();
    names.into_iter().cloned().collect()
}
