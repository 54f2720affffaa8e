//! The tables, the record and the charts of a scaling measurement.

use serde::{Deserialize, Serialize};

use super::curve::{Curve, Point};
use super::{Plan, counters};
use crate::chart::{Axis, Chart, Kind, Series};
use crate::clock::{TOO_SHORT, warning};
use crate::columns::Columns;
use crate::experiment::{Bound, Record, Records};
use crate::published::{self, Scaling};
use lab_kit::table::{Table, three_digits};

/// All numbers.
#[derive(Deserialize, Serialize)]
pub(crate) struct Results {
    pub(super) serial: Vec<Record>,
    pub(super) curves: Vec<Curve>,
    pub(super) streaming_bound: Vec<Bound>,
}

/// Prints a table for each variant, its grade, and what the runs counted.
pub(super) fn print(plan: &Plan, curves: &[Curve], records: &Records) {
    let (serial, n) = (&plan.serial, plan.strong.n());
    for curve in curves {
        println!("{}\n", curve.program);
        if let Some(steps) = curve.strong.first().map(|point| point.record.job.steps) {
            println!("strong: n = {n}, {steps} steps, t1 from {serial}");
        }
        println!("{}", table(&curve.strong, true));
        if let Some(weak) = &plan.weak {
            println!("weak: n = {} per worker, t1 from {serial}", weak.n());
            println!("{}", table(&curve.weak, false));
        }
        println!("{}\n", verdict(curve));
    }
    if let Some(table) = counters::table(curves) {
        println!("What the shortest runs counted\n\n{table}");
    }
    if let Some(record) = records.records.iter().find(|record| record.job.program == *serial) {
        let (ms, n) = (three_digits(record.ms().min), record.job.scene.n());
        println!("t1 = {ms} ms a step: {serial} on one worker, n = {n}");
    }
    println!("{}", records.bounds_in_words());
    let streaming = records.bound(n, false) / records.bound(n, true);
    println!("Streaming on all cores is {streaming:.2} times as fast as on one at n = {n}.");
}

fn table(points: &[Point], strong: bool) -> Table {
    let share = |efficiency| format!("{efficiency:.2}");
    let speed_up = |point: &Point, efficiency| {
        strong.then(|| format!("{:.2}", point.workers as f64 * efficiency))
    };
    Columns::of("workers", |point: &Point| point.workers.to_string())
        .text("n", |point| point.record.job.scene.n().to_string())
        .times("ms a step: ", |point| point.record.ms())
        .text("efficiency", |point| share(point.efficiency))
        .text("own", |point| share(point.own_efficiency))
        .perhaps("speed-up", |point| speed_up(point, point.efficiency))
        .perhaps("own", |point| speed_up(point, point.own_efficiency))
        .text("graded", |point| if point.graded { "yes" } else { "no: cores" }.into())
        .table(points)
}

fn verdict(curve: &Curve) -> String {
    let Some(strong) = curve.average_strong_efficiency else {
        return "No number of workers fits on this machine: no grade.".into();
    };
    let and_weak = |weak: Option<f64>| weak.map_or_else(String::new, |e| format!(", weak {e:.2}"));
    let grade = curve.grades.map_or_else(
        || TOO_SHORT.into(),
        |grade| format!("Grade: {:.2} of 100.{}", grade.min, warning(grade, grade.median)),
    );
    let weak = and_weak(curve.average_weak_efficiency);
    let mut text = format!("Average strong efficiency {strong:.2}{weak}. {grade}");
    if let (Some(strong), weak) = curve.for_marks() {
        let weak = and_weak(weak);
        text += &format!("\nWithout one worker, as for marks: strong {strong:.2}{weak}.");
    }
    text
}

/// The points of a curve, and what is shown of each.
type Points = fn(&Curve) -> &Vec<Point>;
type Value = fn(&Point) -> f64;

impl Results {
    /// Particles of the strong scaling.
    pub(super) fn n(&self) -> usize {
        let mut points = self.curves.iter().flat_map(|curve| &curve.strong);
        points.next().map_or(0, |point| point.record.job.scene.n())
    }

    /// Speed-up, strong efficiency and, where there is one, weak efficiency, side by side.
    pub(super) fn charts(&self) -> Vec<Chart> {
        let strong: Points = |curve| &curve.strong;
        let efficiency: Value = |point| point.efficiency;
        let axis = || Axis::linear("efficiency").starting_at(0.0);
        let best = self.serial.first().map(|record| record.job.program.to_string());
        let best = format!("Speed-up over {}", best.unwrap_or_default());
        let speed_up: Value = |point| point.workers as f64 * point.efficiency;
        let mut charts = vec![
            self.chart(best, Axis::log("speed-up"), (strong, speed_up), Scaling::speedups, |p| p),
            self.chart(
                format!("Strong, n = {}", self.n()),
                axis(),
                (strong, efficiency),
                Scaling::strong_efficiencies,
                |_| 1.0,
            ),
        ];
        let weak = self.curves.iter().flat_map(|curve| &curve.weak).next();
        charts.extend(weak.map(|point| {
            let title = format!("Weak, {} a worker", point.record.job.scene.n() / point.workers);
            let ours: (Points, Value) = (|curve| &curve.weak, efficiency);
            self.chart(title, axis(), ours, Scaling::weak_efficiencies, |_| 1.0)
        }));
        charts
    }

    /// A value against the number of workers, with what a report has for it and what would be ideal.
    fn chart(
        &self,
        title: String,
        y: Axis,
        (points, value): (Points, Value),
        published: fn(&Scaling) -> Vec<f64>,
        ideal: fn(f64) -> f64,
    ) -> Chart {
        let reports = self.reports();
        let theirs = reports.iter().flat_map(|report| report.workers());
        let mut ticks: Vec<f64> = self.workers().chain(theirs).collect();
        ticks.sort_by(f64::total_cmp);
        ticks.dedup();
        let line =
            |curve: &Curve| points(curve).iter().map(|p| (p.workers as f64, value(p))).collect();
        let (named, crowd) = self.named_and_crowd();
        let ours = named
            .iter()
            .map(|curve| Series::new(Kind::Measured, curve.program.to_string(), line(curve)));
        let others = crowd.iter().enumerate().map(|(at, curve)| {
            let name = if at == 0 { format!("{} others", crowd.len()) } else { String::new() };
            Series::new(Kind::Crowd, name, line(curve))
        });
        let theirs = reports.iter().filter_map(|report| {
            let points: Vec<_> = report.workers().zip(published(report)).collect();
            (!points.is_empty()).then(|| Series::new(Kind::Published, &report.name, points))
        });
        Chart::new(title, Axis::log("workers").with_ticks(powers_of_two(&ticks)), y)
            .with_all(others)
            .with_all(ours)
            .with_all(theirs)
            .with(Series::new(Kind::Guide, "ideal", ticks.iter().map(|&p| (p, ideal(p))).collect()))
            .shaded_beyond(self.beyond_the_cores(), "more than cores")
    }

    /// Nobody tells apart more than a few lines: of many, those that are less than half as efficient as the best
    /// are a crowd.
    fn named_and_crowd(&self) -> (Vec<&Curve>, Vec<&Curve>) {
        const FEW: usize = 6;
        let efficiency = |curve: &Curve| curve.average_strong_efficiency.unwrap_or(0.0);
        let best = self.curves.iter().map(efficiency).fold(0.0, f64::max);
        let is_named = |curve: &&Curve| self.curves.len() <= FEW || efficiency(curve) >= best / 2.0;
        self.curves.iter().partition(is_named)
    }

    /// The reports that measured the same programs; or one whose program was of the same kind.
    fn reports(&self) -> Vec<&'static Scaling> {
        let names: Vec<_> =
            self.curves.iter().filter_map(|c| c.program.variant.as_deref()).collect();
        let reports = published::scalings_of(|name| names.contains(&name));
        if !reports.is_empty() {
            return reports;
        }
        let hard = self.curves.iter().any(|curve| curve.program.is_hard());
        vec![published::scaling(
            match (hard, self.curves.iter().any(|curve| curve.program.has_ranks())) {
                (false, false) => "csc581-openmp",
                (false, true) => "csc581-mpi",
                (true, false) => "cs3210-openmp",
                (true, true) => "cs3210-mpi",
            },
        )]
    }

    fn workers(&self) -> impl Iterator<Item = f64> {
        self.curves.iter().flat_map(|curve| &curve.strong).map(|point| point.workers as f64)
    }

    /// Between the greatest number of workers that has its cores and the next one.
    fn beyond_the_cores(&self) -> Option<f64> {
        let points = || self.curves.iter().flat_map(|curve| &curve.strong);
        let within = points().filter(|p| p.graded).map(|p| p.workers).max()? as f64;
        Some(within * 2_f64.sqrt())
    }
}

/// Those of the values that are powers of two, where labels have room; or all, if none is.
fn powers_of_two(values: &[f64]) -> Vec<f64> {
    let powers: Vec<f64> = values.iter().copied().filter(|v| v.log2().fract() == 0.0).collect();
    if powers.is_empty() { values.to_vec() } else { powers }
}
