//! The table and the work-precision diagram.

use super::group::{Group, Point};
use crate::chart::{Axis, Chart, Kind, Series};
use crate::columns::Columns;
use lab_kit::Lab;

/// Formats the results for one n as a table.
pub(super) fn table(group: &Group) -> String {
    let table = Columns::of("* on the Pareto front", |point: &Point| {
        format!("{} {}", if point.on_front { "*" } else { " " }, point.program)
    })
    .text("rms error", |point| format!("{:.2e}", point.rms_error))
    .times("ms: ", |point| point.seconds.span(1e3))
    .number("force eval.", |point| Some(point.force_evaluations))
    .perhaps("energy drift, t = 1", |point| Some(format!("{:.1e}", point.energy_drift?)))
    .table(&group.points);
    format!(
        "n = {}, 100 official steps, one thread, {} takes\nThe reference's own error is {:.1e}\n\n\
         {table}",
        group.n,
        group.points.first().map_or(0, |point| point.seconds.takes.len()),
        group.reference_error
    )
}

/// Plots run time against error, with a line for each variant that divides its step.
///
/// If a lab does not divide its steps, all its programs take the official step, so they differ only
/// in time. They are drawn as single points, in grey if no program of the lab is on the Pareto
/// front.
pub(super) fn chart(group: &Group) -> Chart {
    let mut labs: Vec<Lab> = group.points.iter().map(|point| point.program.lab).collect();
    labs.sort();
    labs.dedup();
    let front: Vec<&Point> = group.points.iter().filter(|point| point.on_front).collect();
    let mut grey = Vec::new();
    let mut behind = Vec::new();
    let mut marks = Vec::new();
    let mut lines: Vec<(String, Vec<&Point>)> = Vec::new();
    for lab in labs {
        let of_lab = group.points.iter().filter(|point| point.program.lab == lab);
        let of_lab: Vec<&Point> = of_lab.collect();
        if of_lab.iter().any(|point| !point.program.parameters.is_empty()) {
            of_lab.into_iter().for_each(|point| add(&mut lines, point));
        } else if of_lab.iter().any(|point| point.on_front) {
            marks.push(Series::new(Kind::Apart, format!("lab {lab}"), costs(&of_lab)));
        } else {
            behind.push(lab);
            grey.extend(of_lab);
        }
    }
    let lines = lines.iter().map(|(name, line)| Series::new(Kind::Measured, name, costs(line)));
    Chart::new(
        format!("Run time against error, n = {}", group.n),
        Axis::log("rms error of positions at t = 0.05"),
        Axis::log("time of 100 official steps [s]"),
    )
    .labelled_directly()
    .with(Series::new(Kind::Guide, "Pareto front", costs(&front)))
    .with(Series::new(Kind::Behind, format!("labs {}", listed(&behind)), costs(&grey)))
    .with_all(marks)
    .with_all(lines)
}

/// Adds a point to the line of its variant.
fn add<'g>(lines: &mut Vec<(String, Vec<&'g Point>)>, point: &'g Point) {
    let variant = point.program.variant.clone().unwrap_or_default();
    let name = if point.program.solution { variant } else { format!("your {variant}") };
    match lines.iter_mut().find(|(known, _)| *known == name) {
        Some((_, points)) => points.push(point),
        None => lines.push((name, vec![point])),
    }
}

/// Returns the error and the run time, in seconds, of each point.
fn costs(points: &[&Point]) -> Vec<(f64, f64)> {
    points.iter().map(|point| (point.rms_error, point.seconds.min)).collect()
}

/// Formats the numbers of labs as ranges: `1–6, 13`.
fn listed(labs: &[Lab]) -> String {
    let numbers: Vec<u32> = labs.iter().filter_map(|lab| lab.to_string().parse().ok()).collect();
    let mut runs = Vec::new();
    for run in numbers.chunk_by(|a, b| a + 1 == *b) {
        match run {
            [first, .., last] => runs.push(format!("{first}–{last}")),
            [one] => runs.push(one.to_string()),
            [] => {}
        }
    }
    runs.join(", ")
}
