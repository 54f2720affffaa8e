//! The table, the record and the work-precision diagram.

use serde_json::{Value, json};

use super::{Group, Point};
use lab_kit::table::{Table, three_digits};
use lab_measure::chart::{Axis, Chart, Series};

/// One n as a table; a star marks the Pareto front.
pub(super) fn table(group: &Group) -> String {
    let mut table = Table::new([
        "variant and parameter",
        "rms error",
        "ms: min",
        "median",
        "force evaluations",
        "energy drift at t = 1",
        "front",
    ]);
    for point in &group.points {
        table.row([
            point.candidate.program.to_string(),
            format!("{:.2e}", point.error),
            three_digits(1e3 * point.times.min()),
            three_digits(1e3 * point.times.median()),
            three_digits(point.evaluations),
            point.drift.map_or_else(String::new, |drift| format!("{drift:.1e}")),
            if point.on_front { "*" } else { "" }.to_owned(),
        ]);
    }
    format!(
        "n = {}, 100 official steps, one thread, {} takes; the reference's own error is {:.1e}\n\n\
         {table}",
        group.n,
        group.points.first().map_or(0, |point| point.times.takes()),
        group.reference_error
    )
}

/// All numbers, a line each.
pub(super) fn csv(groups: &[Group]) -> String {
    let mut text = String::from(
        "n,program,divide,rms_error,seconds_min,seconds_median,force_evaluations,energy_drift,front,reference_error\n",
    );
    for group in groups {
        for point in &group.points {
            text += &format!(
                "{},\"{}\",{},{:e},{:e},{:e},{},{},{},{:e}\n",
                group.n,
                point.candidate.program,
                point.candidate.divide,
                point.error,
                point.times.min(),
                point.times.median(),
                point.evaluations,
                point.drift.map_or_else(String::new, |drift| format!("{drift:e}")),
                point.on_front,
                group.reference_error
            );
        }
    }
    text
}

pub(super) fn results(groups: &[Group]) -> Value {
    let of = |point: &Point| {
        json!({
            "program": point.candidate.program.to_string(), "n": point.n,
            "divide": point.candidate.divide, "rms_error": point.error, "seconds": point.times,
            "force_evaluations": point.evaluations, "energy_drift": point.drift,
            "on_front": point.on_front,
        })
    };
    let group = |group: &Group| {
        json!({
            "n": group.n, "reference_error": group.reference_error,
            "points": group.points.iter().map(of).collect::<Vec<_>>(),
        })
    };
    json!(groups.iter().map(group).collect::<Vec<_>>())
}

/// Error against seconds, a chart for each n.
pub(super) fn charts(groups: &[Group]) -> Vec<Chart> {
    groups.iter().map(chart).collect()
}

/// A line for each variant that divides its step, one set of marks for all that do not, and the
/// front as a grey line.
fn chart(group: &Group) -> Chart {
    let at = |point: &Point| (point.error, point.times.min());
    let divides = |lab| {
        let programs = group.points.iter().map(|point| &point.candidate.program);
        programs.filter(|program| program.lab == lab).any(|program| !program.parameters.is_empty())
    };
    let mut lines: Vec<(String, Vec<(f64, f64)>)> = Vec::new();
    for point in &group.points {
        let program = &point.candidate.program;
        let variant = program.variant.as_deref().unwrap_or_default();
        // A lab that never divides its step takes the official one: what differs is the time.
        let name = if !divides(program.lab) {
            format!("lab {}, official step", program.lab)
        } else {
            variant.to_owned()
        };
        match lines.iter_mut().find(|(known, _)| *known == name) {
            Some((_, points)) => points.push(at(point)),
            None => lines.push((name, vec![at(point)])),
        }
    }
    let mut front: Vec<_> = group.points.iter().filter(|p| p.on_front).map(at).collect();
    front.sort_by(|a, b| a.0.total_cmp(&b.0));
    for (_, points) in &mut lines {
        points.retain(|p| p.0.is_finite() && p.0 > 0.0);
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
    }
    Chart::new(
        format!("Run time against error, n = {}", group.n),
        Axis::log("rms error of the places at t = 0.05"),
        Axis::log("time of 100 official steps [s]"),
    )
    .with_all(lines.into_iter().map(|(name, points)| Series::measured(name, points)))
    .with(Series::guide("Pareto front", front))
}
