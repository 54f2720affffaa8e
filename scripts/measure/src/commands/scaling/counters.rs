//! Counters of strong scaling, and the parts of a step that they measure.

use std::collections::BTreeSet;

use anyhow::{Result, bail};

use super::curve::{Curve, Point};
use crate::chart::{Axis, Chart, Kind, Series};
use crate::columns::Columns;
use lab_kit::table::Table;

/// Makes a row for each run with counters and a column for each counter; `None` if no run has
/// counters.
pub(super) fn table(curves: &[Curve]) -> Option<Table> {
    let names = counter_names(curves);
    let mut rows = Vec::new();
    for curve in curves {
        let counting = curve.strong.iter().filter(|point| !point.timing.counters.is_empty());
        rows.extend(counting.map(|point| (&curve.program, point)));
    }
    let columns = Columns::of("program, workers", |(program, point): &(_, &Point)| {
        format!("{program}, {}", point.workers)
    });
    let columns =
        columns.numbers(&names, |(_, point), at| point.timing.counters.get(&names[at]).copied());
    (!names.is_empty()).then(|| columns.table(&rows))
}

/// Plots a counter against the number of workers.
pub(super) fn chart(curves: &[Curve], n: usize, name: &str) -> Result<Chart> {
    let counter = &counter_named(curves, name)?;
    let workers = curves.iter().flat_map(|curve| &curve.strong).map(|point| point.workers as f64);
    let x = Axis::log("workers").with_ticks(workers);
    let y = Axis::linear(counter.as_str()).starting_at(0.0);
    let mut chart = Chart::new(format!("Counted, n = {n}"), x, y);
    for curve in curves {
        let mut line = Vec::new();
        for point in &curve.strong {
            let counted = point.timing.counters.get(counter);
            line.extend(counted.map(|counted| (point.workers as f64, *counted)));
        }
        if !line.is_empty() {
            chart = chart.with(Series::new(Kind::Measured, curve.program.to_string(), line));
        }
    }
    Ok(chart)
}

/// Finds the only counter whose name contains `name`.
fn counter_named(curves: &[Curve], name: &str) -> Result<String> {
    let names = counter_names(curves);
    let fitting: Vec<&String> = names.iter().filter(|known| known.contains(name)).collect();
    match fitting.as_slice() {
        [counter] => Ok(counter.to_string()),
        several => {
            let count = several.len();
            bail!("'{name}' fits {count} of the counters: {}", names.join("; "))
        }
    }
}

fn counter_names(curves: &[Curve]) -> Vec<String> {
    let points = curves.iter().flat_map(|curve| &curve.strong);
    let names: BTreeSet<&String> = points.flat_map(|point| point.timing.counters.keys()).collect();
    names.into_iter().cloned().collect()
}

/// Parts of a step for every run of the strong scaling, in milliseconds, averaged over the workers.
pub(super) struct Breakdown {
    /// Names of the parts on the command line, and finally the rest of the step.
    parts: Vec<String>,
    /// The name of each run, by variant and workers, and its parts.
    rows: Vec<(String, Vec<f64>)>,
}

impl Breakdown {
    /// Finds the counters whose names contain `names`. A program without any of these counters is
    /// omitted.
    pub(super) fn new(curves: &[Curve], names: &[String]) -> Result<Self> {
        let mut parts = names.to_vec();
        parts.push("rest".into());
        let counters: Vec<String> =
            names.iter().map(|name| counter_named(curves, name)).collect::<Result<_>>()?;
        let mut rows = Vec::new();
        for curve in curves {
            let program_name = curve.program.to_string();
            let name = curve.program.variant.as_ref().unwrap_or(&program_name);
            for point in &curve.strong {
                if let Some(parts) = point.parts(&counters) {
                    rows.push((format!("{name}, {}", point.workers), parts));
                }
            }
        }
        Ok(Self { parts, rows })
    }

    pub(super) fn chart(&self, n: usize) -> Chart {
        let title = format!("Where the time of a step goes, n = {n}");
        let x = Axis::linear("ms a step, mean of the workers").starting_at(0.0);
        let parts: Vec<&str> = self.parts.iter().map(String::as_str).collect();
        Chart::bars(title, x, &parts, &self.rows)
    }

    /// Makes a table with a row for each run and a column for each part.
    pub(super) fn table(&self) -> Table {
        Columns::of("program, workers", |row: &(String, Vec<f64>)| row.0.clone())
            .numbers(&self.parts, |row, at| Some(row.1[at]))
            .table(&self.rows)
    }
}

impl Point {
    /// Returns the milliseconds of a step that each counter measures, and the rest of the step;
    /// `None` if the run has no such counter.
    fn parts(&self, counters: &[String]) -> Option<Vec<f64>> {
        counters.iter().find(|name| self.timing.counters.contains_key(*name))?;
        let mut parts = Vec::new();
        for name in counters {
            let seconds = self.timing.per_step(name).unwrap_or(0.0);
            parts.push(1e3 * seconds / self.workers as f64);
        }
        parts.push((self.timing.ms().min - parts.iter().sum::<f64>()).max(0.0));
        Some(parts)
    }
}
