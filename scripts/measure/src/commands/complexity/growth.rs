//! The chart of growth for `cargo lab complexity`.

use super::line::Line;
use crate::chart::{Axis, Chart, Kind, Series};
use crate::published::{self, HARD_STEPS, SOFT_STEPS};

/// Greatest slope for which the chart shows the time per particle.
const NEARLY_LINEAR: f64 = 1.5;

/// Plots times against n. If all programs are nearly linear in n, the chart shows the time per
/// particle, and otherwise the time of a run.
///
/// The chart includes the tables of the course reports. If there are several numbers of workers,
/// the chart shows only the greatest number.
pub(super) fn chart(lines: &[Line]) -> Chart {
    let most = lines.iter().map(|line| line.workers).max().unwrap_or(1);
    let lines: Vec<&Line> = lines.iter().filter(|line| line.workers == most).collect();
    let hard = lines.iter().any(|line| line.program.is_hard());
    let each = lines.iter().all(|line| line.slope_by_time < NEARLY_LINEAR);
    let steps = if hard { HARD_STEPS } else { SOFT_STEPS };
    let what = if hard { "disc" } else { "particle" };
    let (title, y) = match each {
        true => (format!("Time of a {what} in a step"), format!("ns a {what} and step")),
        false => (format!("Time of {steps} steps"), "time [s]".into()),
    };
    let mut chart = Chart::new(title, Axis::log(format!("{what}s n")), Axis::log(y));
    let mut all = Vec::new();
    for line in lines {
        let points = line.points.iter().map(|p| (p.n(), p.timing.ms().min * 1e-3 * steps));
        let points = shown(points, each.then_some(steps));
        all.extend(points.iter().copied());
        chart = chart.with(Series::new(Kind::Measured, line.name(), points));
    }
    for name in beside(hard, most > 1) {
        let report = published::growth(name);
        let points = shown(report.points.iter().copied(), each.then_some(steps));
        chart = chart.with(Series::new(Kind::Published, &report.name, points));
    }
    if each { chart } else { chart.with_all(guides(&all)) }
}

/// Converts (n, seconds of a run) to nanoseconds per particle and step, if the number of `steps` is
/// given.
fn shown(runs: impl Iterator<Item = (f64, f64)>, steps: Option<f64>) -> Vec<(f64, f64)> {
    runs.map(|(n, seconds)| (n, steps.map_or(seconds, |steps| 1e9 * seconds / steps / n))).collect()
}

/// Returns the names of the course reports' tables that the chart includes.
fn beside(hard: bool, parallel: bool) -> &'static [&'static str] {
    match (hard, parallel) {
        (true, _) => &["cs3210-openmp-growth", "cs3210-cuda-growth", "cs3210-mpi-growth"],
        (false, true) => &["cs267-4-threads", "cs267-32-threads"],
        (false, false) => &["csc581-serial", "csc367-serial", "cs267-preliminary", "cs267-final"],
    }
}

/// Makes lines of slope 1 and 2 from the lower left corner of the measured points to where the
/// points end, to the right or upwards.
fn guides(points: &[(f64, f64)]) -> [Series; 2] {
    let first = points.iter().map(|point| point.0).fold(f64::INFINITY, f64::min);
    let last = points.iter().map(|point| point.0).fold(0.0, f64::max);
    let low = 0.7 * points.iter().map(|point| point.1).fold(f64::INFINITY, f64::min);
    let high = points.iter().map(|point| point.1).fold(0.0, f64::max);
    [1, 2].map(|power| {
        let reach = (last / first).min((2.0 * high / low).powf(1.0 / f64::from(power)));
        let end = (first * reach, low * reach.powi(power));
        Series::new(Kind::Guide, format!("slope {power}"), vec![(first, low), end])
    })
}
