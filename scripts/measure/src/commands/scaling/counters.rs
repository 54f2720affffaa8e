//! What the runs of a strong scaling counted, and where the time of a step goes by what they counted.

use std::collections::BTreeSet;

use anyhow::{Result, bail};

use super::curve::{Curve, Point};
use crate::chart::{Axis, Chart, Kind, Series};
use crate::columns::Columns;
use lab_kit::table::Table;

/// A row for each run that counts anything, a column for each counter; none if nothing is counted.
pub(super) fn table(curves: &[Curve]) -> Option<Table> {
    let names = counter_names(curves);
    let runs = curves.iter().flat_map(|c| c.strong.iter().map(move |p| (&c.program, p)));
    let rows: Vec<_> = runs.filter(|(_, point)| !point.record.counters.is_empty()).collect();
    let columns = Columns::of("program, workers", |(program, point): &(_, &Point)| {
        format!("{program}, {}", point.workers)
    });
    let counted =
        |(_, point): &(_, &Point), at: usize| point.record.counters.get(&names[at]).copied();
    (!names.is_empty()).then(|| columns.numbers(&names, counted).table(&rows))
}

/// What the programs that count it counted, against the workers.
///
/// # Errors
/// No program counts it, or the name fits several counters.
pub(super) fn chart(curves: &[Curve], n: usize, name: &str) -> Result<Chart> {
    let counter = &counter_named(curves, name)?;
    let points = || curves.iter().flat_map(|curve| &curve.strong);
    let line = |curve: &Curve| {
        let point = |p: &Point| Some((p.workers as f64, *p.record.counters.get(counter)?));
        let line: Vec<_> = curve.strong.iter().filter_map(point).collect();
        (!line.is_empty()).then(|| Series::new(Kind::Measured, curve.program.to_string(), line))
    };
    let x = Axis::log("workers").with_ticks(points().map(|point| point.workers as f64));
    let y = Axis::linear(counter.as_str()).starting_at(0.0);
    Ok(Chart::new(format!("Counted, n = {n}"), x, y).with_all(curves.iter().filter_map(line)))
}

/// The one counter whose name holds `name`.
///
/// # Errors
/// No program counts it, or the name fits several counters.
pub(super) fn counter_named(curves: &[Curve], name: &str) -> Result<String> {
    let mut names = counter_names(curves);
    let mut fitting = (0..names.len()).filter(|&at| names[at].contains(name));
    match (fitting.next(), fitting.count()) {
        (Some(at), 0) => Ok(names.swap_remove(at)),
        (first, further) => {
            let count = usize::from(first.is_some()) + further;
            bail!("'{name}' fits {count} of the counters: {}", names.join("; "))
        }
    }
}

fn counter_names(curves: &[Curve]) -> Vec<String> {
    let points = curves.iter().flat_map(|curve| &curve.strong);
    let names: BTreeSet<&String> = points.flat_map(|p| p.record.counters.keys()).collect();
    names.into_iter().cloned().collect()
}

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
