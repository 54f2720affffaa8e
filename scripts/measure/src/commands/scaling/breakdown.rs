//! Where the time of a step goes.

use anyhow::Result;
use lab_kit::table::Table;

use super::counters::counter_named;
use super::curve::{Curve, Point};
use crate::chart::{Axis, Chart};
use crate::columns::Columns;

/// The parts of a step of every run of the strong scaling, in milliseconds, as the mean of its workers.
pub(super) struct Breakdown {
    /// What the parts are called on the command line; the last is the rest of the step.
    parts: Vec<String>,
    /// A run, by variant and workers, and its parts.
    rows: Vec<(String, Vec<f64>)>,
}

impl Breakdown {
    /// The parts by the counters that `names` fit; a program that counts none of them is left out.
    ///
    /// # Errors
    /// A name fits no counter, or several.
    pub(super) fn new(curves: &[Curve], names: &[String]) -> Result<Self> {
        let counters: Vec<String> =
            names.iter().map(|name| counter_named(curves, name)).collect::<Result<_>>()?;
        let row = |curve: &Curve, point: &Point| {
            let Point { workers, record, .. } = point;
            counters.iter().find(|name| record.counters.contains_key(*name))?;
            let part = |name: &String| 1e3 * record.per_step(name).unwrap_or(0.0) / *workers as f64;
            let mut parts: Vec<f64> = counters.iter().map(part).collect();
            parts.push((record.ms().min - parts.iter().sum::<f64>()).max(0.0));
            let whole = curve.program.to_string();
            let name = curve.program.variant.as_ref().unwrap_or(&whole);
            Some((format!("{name}, {workers}"), parts))
        };
        let rows =
            curves.iter().flat_map(|curve| curve.strong.iter().filter_map(|p| row(curve, p)));
        let parts = names.iter().cloned().chain(["rest".into()]);
        Ok(Self { parts: parts.collect(), rows: rows.collect() })
    }

    /// A bar for each run.
    pub(super) fn chart(&self, n: usize) -> Chart {
        let title = format!("Where the time of a step goes, n = {n}");
        let x = Axis::linear("ms a step, mean of the workers").starting_at(0.0);
        let parts: Vec<&str> = self.parts.iter().map(String::as_str).collect();
        Chart::bars(title, x, &parts, &self.rows)
    }

    /// A row for each run, a column for each part.
    pub(super) fn table(&self) -> Table {
        Columns::of("program, workers", |row: &(String, Vec<f64>)| row.0.clone())
            .numbers(&self.parts, |row, at| Some(row.1[at]))
            .table(&self.rows)
    }
}
