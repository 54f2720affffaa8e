//! The table, the record and the chart of a sweep.

use serde_json::{Value, json};

use super::{Axis, Cell, Sweep};
use crate::chart::{self, Chart, Series};
use crate::job::{Random, Scene};
use crate::published::{self, HARD_STEPS, Report};
use crate::rounds::Rounds;
use lab_kit::table::{Table, three_digits};

/// A row for each variant at each value.
pub(super) fn table(sweep: &Sweep) -> Table {
    let mut table = Table::new([
        &sweep.axis.to_string(),
        "variant",
        "ms a step: min",
        "median",
        "spread",
        "ratio of min",
        "of median",
        "pair tests a step",
        "report, ms",
        "",
    ]);
    for cell in &sweep.cells {
        let first = sweep.first_at(cell.value);
        let times = &cell.measured.times;
        // Seconds of one step: the runs of a sweep are of different length.
        let scale = first.measured.job.steps as f64 / cell.measured.job.steps as f64;
        let ratio = times.over(&first.measured.times);
        let decided = times.min() * scale > first.measured.times.median()
            || first.measured.times.min() > times.median() * scale;
        table.row([
            cell.value.to_string(),
            cell.name.clone(),
            three_digits(cell.ms(times.min())),
            three_digits(cell.ms(times.median())),
            format!("{:.0} %", 100.0 * times.spread()),
            three_digits(ratio.of_minima * scale),
            three_digits(ratio.of_medians * scale),
            cell.pair_tests().map_or(String::new(), three_digits),
            match report(sweep, cell) {
                Some(Report::Seconds(seconds)) => three_digits(seconds * 1e3 / HARD_STEPS),
                Some(Report::Crashes) => "crashes".into(),
                None => String::new(),
            },
            if decided || std::ptr::eq(cell, first) { "" } else { "spread too wide to decide" }
                .into(),
        ]);
    }
    table
}

/// What the CS3210 report has for the same program on the same scene, on its own machine.
fn report(sweep: &Sweep, cell: &Cell) -> Option<Report> {
    let Scene::Hard { n, side, radius, random } = cell.measured.job.scene else { return None };
    if random != Random::default() {
        return None;
    }
    let workers = matches!(sweep.axis, Axis::Threads | Axis::Ranks).then_some(cell.value as usize);
    published::hard_discs(
        cell.measured.job.program.workers(),
        &cell.name,
        (n, side, radius),
        workers,
    )
}

/// Everything, for a record.
pub(super) fn results(sweep: &Sweep, rounds: &Rounds) -> Value {
    let cells = sweep.cells.iter().map(|cell| {
        let mut row = cell.measured.as_json();
        row[sweep.axis.to_string()] = json!(cell.value);
        row["variant"] = json!(cell.name);
        row["ms_per_step"] = json!({
            "min": cell.ms(cell.measured.times.min()),
            "median": cell.ms(cell.measured.times.median()),
        });
        row["pair_tests_per_step"] = json!(cell.pair_tests());
        row["report_ms_per_step"] = match report(sweep, cell) {
            Some(Report::Seconds(seconds)) => json!(seconds * 1e3 / HARD_STEPS),
            Some(Report::Crashes) => json!("crashes"),
            None => Value::Null,
        };
        row
    });
    json!({
        "over": sweep.axis.to_string(),
        "runs": cells.collect::<Vec<_>>(),
        "streaming_bound": rounds.bounds,
    })
}

/// The shortest takes against what varies, with the report's dashed.
pub(super) fn chart(sweep: &Sweep) -> Chart {
    let of = |name: &str, y: &dyn Fn(&Cell) -> Option<f64>| -> Vec<(f64, f64)> {
        let cells = sweep.cells.iter().filter(|cell| cell.name == name);
        cells.filter_map(|cell| Some((cell.value, y(cell)?))).collect()
    };
    let mut series = Vec::new();
    for name in sweep.names() {
        series.push(Series::measured(
            name,
            of(name, &|cell| Some(cell.ms(cell.measured.times.min()))),
        ));
    }
    for name in sweep.names() {
        let points = of(name, &|cell| match report(sweep, cell)? {
            Report::Seconds(seconds) => Some(seconds * 1e3 / HARD_STEPS),
            Report::Crashes => None,
        });
        if !points.is_empty() {
            series.push(Series::published(format!("CS3210 report, as {name}"), points));
        }
    }
    let times = sweep.cells.iter().map(|cell| cell.ms(cell.measured.times.min()));
    Chart::new(
        format!("Time of a step against {}", sweep.axis),
        axis(sweep.axis.label(), sweep.cells.iter().map(|cell| cell.value)),
        axis("ms a step".into(), times),
    )
    .with_all(series)
}

/// Logarithmic where the values span a decade.
fn axis(label: String, values: impl Iterator<Item = f64> + Clone) -> chart::Axis {
    let least = values.clone().fold(f64::INFINITY, f64::min);
    let most = values.fold(0.0, f64::max);
    if least > 0.0 && most >= 10.0 * least {
        chart::Axis::log(label)
    } else {
        chart::Axis::linear(label)
    }
}
