//! The results of a scaling measurement, and their charts.

use serde::{Deserialize, Serialize};

use super::curve::{Curve, Point};
use crate::chart::{Axis, Chart, Kind, Series};
use crate::experiment::{Bound, Timing};
use crate::published::{self, Scaling};

#[derive(Deserialize, Serialize)]
pub(crate) struct Results {
    pub(super) serial: Vec<Timing>,
    pub(super) curves: Vec<Curve>,
    pub(super) streaming_bound: Vec<Bound>,
}

impl Results {
    /// Returns the number of particles of the strong scaling.
    pub(super) fn n(&self) -> usize {
        self.strong().next().map_or(0, |point| point.timing.job.scene.n())
    }

    fn strong(&self) -> impl Iterator<Item = &Point> {
        self.curves.iter().flat_map(|curve| &curve.strong)
    }

    /// Plots speed-up and efficiencies side by side. The efficiency of weak scaling is included if
    /// it was measured.
    pub(super) fn charts(&self) -> Vec<Chart> {
        let best = self.serial.first().map(|timing| timing.job.program.to_string());
        let title = format!("Speed-up over {}", best.unwrap_or_default());
        let y = Axis::log("speed-up");
        let mut charts = vec![self.chart(title, y, speedups, Scaling::speedups, |p| p)];
        let title = format!("Strong, n = {}", self.n());
        let y = Axis::linear("efficiency").starting_at(0.0);
        charts.push(self.chart(title, y.clone(), strong, Scaling::strong_efficiencies, |_| 1.0));
        if let Some(point) = self.curves.iter().flat_map(|curve| &curve.weak).next() {
            let each = point.timing.job.scene.n() / point.workers;
            let title = format!("Weak, {each} a worker");
            charts.push(self.chart(title, y, weak, Scaling::weak_efficiencies, |_| 1.0));
        }
        charts
    }

    /// Plots each curve against the number of workers, with the lines of the reports and the ideal
    /// line.
    fn chart(
        &self,
        title: String,
        y: Axis,
        line: fn(&Curve) -> Vec<(f64, f64)>,
        published: fn(&Scaling) -> Vec<f64>,
        ideal: fn(f64) -> f64,
    ) -> Chart {
        let reports = self.reports();
        let theirs = reports.iter().flat_map(|report| report.workers());
        let mut ticks: Vec<f64> = self.strong().map(|point| point.workers as f64).collect();
        ticks.extend(theirs);
        ticks.sort_by(f64::total_cmp);
        ticks.dedup();
        let x = Axis::log("workers").with_ticks(powers_of_two(&ticks));
        let mut chart = Chart::new(title, x, y);
        let (named, crowd) = self.named_and_crowd();
        for (at, curve) in crowd.iter().enumerate() {
            let name = if at == 0 { format!("{} others", crowd.len()) } else { String::new() };
            chart = chart.with(Series::new(Kind::Crowd, name, line(curve)));
        }
        for curve in named {
            let name = curve.program.to_string();
            chart = chart.with(Series::new(Kind::Measured, name, line(curve)));
        }
        for report in reports {
            let points: Vec<_> = report.workers().zip(published(report)).collect();
            if !points.is_empty() {
                chart = chart.with(Series::new(Kind::Published, &report.name, points));
            }
        }
        let ideal = ticks.iter().map(|&p| (p, ideal(p))).collect();
        chart
            .with(Series::new(Kind::Guide, "ideal", ideal))
            .shaded_beyond(self.beyond_the_cores(), "more than cores")
    }

    /// Separates the curves with a name from the others.
    ///
    /// A reader cannot distinguish more than a few lines. If there are many lines, the lines whose
    /// efficiency is less than half the best have no name.
    fn named_and_crowd(&self) -> (Vec<&Curve>, Vec<&Curve>) {
        const MOST_NAMES: usize = 6;
        let efficiencies = self.curves.iter().filter_map(|curve| curve.average_strong_efficiency);
        let best = efficiencies.fold(0.0, f64::max);
        self.curves.iter().partition(|curve| {
            let efficiency = curve.average_strong_efficiency.unwrap_or(0.0);
            self.curves.len() <= MOST_NAMES || efficiency >= best / 2.0
        })
    }

    /// Finds the reports that measured the same programs, or else the report with a program of the
    /// same kind.
    fn reports(&self) -> Vec<&'static Scaling> {
        let variants = self.curves.iter().filter_map(|curve| curve.program.variant.as_deref());
        let reports = published::scalings_of(&variants.collect::<Vec<_>>());
        if !reports.is_empty() {
            return reports;
        }
        let hard = self.curves.iter().any(|curve| curve.program.is_hard());
        let ranks = self.curves.iter().any(|curve| curve.program.has_ranks());
        vec![published::scaling(match (hard, ranks) {
            (false, false) => "csc581-openmp",
            (false, true) => "csc581-mpi",
            (true, false) => "cs3210-openmp",
            (true, true) => "cs3210-mpi",
        })]
    }

    /// Returns the x beyond which a chart shows more workers than cores. It is √2 times the
    /// greatest measured number of workers that does not exceed the number of cores.
    fn beyond_the_cores(&self) -> Option<f64> {
        let within = self.strong().filter(|point| point.graded).map(|point| point.workers).max()?;
        Some(within as f64 * 2_f64.sqrt())
    }
}

fn speedups(curve: &Curve) -> Vec<(f64, f64)> {
    strong(curve).into_iter().map(|(p, efficiency)| (p, p * efficiency)).collect()
}

fn strong(curve: &Curve) -> Vec<(f64, f64)> {
    curve.strong.iter().map(|point| (point.workers as f64, point.efficiency)).collect()
}

fn weak(curve: &Curve) -> Vec<(f64, f64)> {
    curve.weak.iter().map(|point| (point.workers as f64, point.efficiency)).collect()
}

/// Returns only the powers of two among the values, because labels need room. Returns all values if
/// there are no powers of two.
fn powers_of_two(values: &[f64]) -> Vec<f64> {
    let powers: Vec<f64> = values.iter().copied().filter(|v| v.log2().fract() == 0.0).collect();
    if powers.is_empty() { values.to_vec() } else { powers }
}
