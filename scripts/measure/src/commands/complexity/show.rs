//! The table, the record and the chart of a complexity measurement.

use serde_json::{Value, json};

use super::Line;
use crate::chart::{Axis, Chart, Series};
use crate::published::{self, Growth};
use crate::rounds::Rounds;
use crate::rubric::{complexity_grade, slope};
use lab_kit::table::{Table, three_digits};

/// Prints a table for each line, and its grade.
pub(super) fn print(lines: &[Line], rounds: &Rounds) {
    for line in lines {
        println!("{}\n\n{}", line.name(), table(line, rounds));
        println!("{}\n", verdict(line));
    }
}

fn table(line: &Line, rounds: &Rounds) -> Table {
    let mut table = Table::new([
        "n",
        "steps",
        "ms a step: min",
        "median",
        "slope",
        "ns per particle",
        "pair tests per particle",
        "slope",
        "streaming bound [ns]",
    ]);
    let seconds = line.seconds(|m| m.times.min());
    for (at, measured) in line.points.iter().enumerate() {
        let n = measured.job.scene.n();
        let steps = measured.job.steps;
        let ms = |seconds: f64| three_digits(seconds * 1e3 / steps as f64);
        let pairs = line.pair_tests[at];
        let before = at.checked_sub(1);
        let slope_of_pairs = before.and_then(|before| {
            let n = seconds[before].0;
            Some(slope(&[(n, line.pair_tests[before]?), (seconds[at].0, pairs?)]))
        });
        table.row([
            n.to_string(),
            steps.to_string(),
            ms(measured.times.min()),
            ms(measured.times.median()),
            digits(before.map(|before| slope(&seconds[before..=at]))),
            three_digits(measured.nanoseconds(measured.times.min())),
            pairs.map_or("".into(), |pairs| three_digits(pairs / n as f64)),
            digits(slope_of_pairs),
            three_digits(rounds.bound(n, line.workers > 1)),
        ]);
    }
    table
}

fn digits(slope: Option<f64>) -> String {
    slope.map_or_else(String::new, |slope| format!("{slope:.2}"))
}

fn verdict(line: &Line) -> String {
    let (by_time, by_median) = (line.slope(), line.slope_of_medians());
    let grade = complexity_grade(by_time);
    let mut text = format!("The time grows as n to the power {by_time:.3}");
    let pairs = line.pairs();
    if pairs.len() > 1 {
        text += &format!(", the pairs that are looked at as n to the power {:.3}", slope(&pairs));
    }
    text += &format!(". Grade: {grade:.2} of 100.");
    if (complexity_grade(by_median) - grade).abs() > 5.0 {
        text += &format!(
            "\nBy the medians it is {by_median:.3}: the times spread too wide to decide. \
             Close other programs and measure again."
        );
    }
    text
}

/// All numbers.
pub(super) fn results(lines: &[Line], rounds: &Rounds) -> Value {
    let lines = lines.iter().map(|line| {
        let pairs = line.pairs();
        let points = line.points.iter().zip(&line.pair_tests).map(|(measured, pairs)| {
            let mut point = measured.as_json();
            point["pair_tests_per_step"] = json!(pairs);
            point
        });
        json!({
            "program": line.program.to_string(), "workers": line.workers,
            "slope_by_time": line.slope(), "slope_by_median": line.slope_of_medians(),
            "slope_by_pair_tests": (pairs.len() > 1).then(|| slope(&pairs)),
            "grade": complexity_grade(line.slope()), "points": points.collect::<Vec<_>>(),
        })
    });
    json!({ "lines": lines.collect::<Vec<_>>(), "streaming_bound": rounds.bounds })
}

/// Time of as many steps as the reports ran against n, the reports' beside it.
pub(super) fn chart(lines: &[Line]) -> Chart {
    let hard = lines.iter().any(|line| line.program.is_hard());
    let steps = if hard { published::HARD_STEPS } else { published::SOFT_STEPS };
    let total = |points: Vec<(f64, f64)>| -> Vec<(f64, f64)> {
        points.into_iter().map(|(n, step)| (n, step * steps)).collect()
    };
    let measured: Vec<(String, Vec<(f64, f64)>)> =
        lines.iter().map(|line| (line.name(), total(line.seconds(|m| m.times.min())))).collect();
    let what = if hard { "discs" } else { "particles" };
    let guides = guides(measured.iter().flat_map(|(_, points)| points.iter().copied()));
    Chart::new(
        format!("Time of {steps} steps"),
        Axis::log(format!("{what} n")),
        Axis::log("time [s]"),
    )
    .with_all(measured.into_iter().map(|(name, points)| Series::measured(name, points)))
    .with_all(beside(lines).iter().map(|t| Series::published(&t.name, t.points.clone())))
    .with_all(guides)
}

/// The tables of the course reports that belong beside these lines.
fn beside(lines: &[Line]) -> Vec<&'static Growth> {
    let names: &[&str] = if lines.iter().any(|line| line.program.is_hard()) {
        &["cs3210-openmp-growth", "cs3210-cuda-growth", "cs3210-mpi-growth"]
    } else if lines.iter().any(|line| line.workers > 1) {
        &[
            "csc581-serial",
            "csc367-serial",
            "cs267-preliminary",
            "cs267-final",
            "cs267-4-threads",
            "cs267-16-threads",
            "cs267-32-threads",
        ]
    } else {
        &["csc581-serial", "csc367-serial", "cs267-preliminary", "cs267-final"]
    };
    names.iter().map(|name| published::growth(name)).collect()
}

/// Lines of slope 1 and 2 through the lower left corner of what was measured.
fn guides(points: impl Iterator<Item = (f64, f64)> + Clone) -> Vec<Series> {
    let least = |values: &mut dyn Iterator<Item = f64>| values.fold(f64::INFINITY, f64::min);
    let first = least(&mut points.clone().map(|p| p.0));
    let low = 0.7 * least(&mut points.clone().map(|p| p.1));
    let high = points.clone().map(|p| p.1).fold(0.0, f64::max);
    let last = points.map(|p| p.0).fold(0.0, f64::max);
    [1, 2]
        .into_iter()
        .map(|power| {
            // As far as the points go, to the right and upwards.
            let reach = (last / first).min((2.0 * high / low).powf(1.0 / f64::from(power)));
            let end = (first * reach, low * reach.powi(power));
            Series::guide(format!("slope {power}"), vec![(first, low), end])
        })
        .collect()
}
