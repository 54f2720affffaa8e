//! The table and the work-precision diagram.

use super::Group;
use super::Point;
use lab_kit::Lab;
use lab_measure::chart::{Axis, Chart, Kind, Series};
use lab_measure::columns::Columns;

/// One n as a table.
pub(super) fn table(group: &Group) -> String {
    let mark = |point: &Point| if point.on_front { "*" } else { " " };
    let table = Columns::of("* on the Pareto front", |point: &Point| {
        format!("{} {}", mark(point), point.program)
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

/// Error against seconds: a line for each variant that divides its step. A lab that does not takes the official
/// step, and what differs is the time: marks, in grey where none of them is on the front, which is a grey line.
pub(super) fn chart(group: &Group) -> Chart {
    let at = |point: &Point| (point.rms_error, point.seconds.min);
    let of = |lab: Lab| group.points.iter().filter(move |point| point.program.lab == lab);
    let divides = |lab| of(lab).any(|point| !point.program.parameters.is_empty());
    let mut labs: Vec<Lab> = group.points.iter().map(|point| point.program.lab).collect();
    labs.sort();
    labs.dedup();
    let (dividing, others): (Vec<Lab>, Vec<Lab>) = labs.into_iter().partition(|&lab| divides(lab));
    let (fast, behind): (Vec<Lab>, Vec<Lab>) =
        others.into_iter().partition(|&lab| of(lab).any(|point| point.on_front));
    let mut lines: Vec<(String, Vec<(f64, f64)>)> = Vec::new();
    for point in dividing.into_iter().flat_map(of) {
        let variant = point.program.variant.clone().unwrap_or_default();
        let name = if point.program.solution { variant } else { format!("your {variant}") };
        match lines.iter_mut().find(|(known, _)| *known == name) {
            Some((_, points)) => points.push(at(point)),
            None => lines.push((name, vec![at(point)])),
        }
    }
    let front = group.points.iter().filter(|point| point.on_front).map(at).collect();
    let grey = behind.iter().flat_map(|&lab| of(lab)).map(at).collect();
    let fast = fast
        .into_iter()
        .map(|lab| Series::new(Kind::Apart, format!("lab {lab}"), of(lab).map(at).collect()));
    Chart::new(
        format!("Run time against error, n = {}", group.n),
        Axis::log("rms error of positions at t = 0.05"),
        Axis::log("time of 100 official steps [s]"),
    )
    .labelled_directly()
    .with(Series::new(Kind::Guide, "Pareto front", front))
    .with(Series::new(Kind::Behind, format!("labs {}", listed(&behind)), grey))
    .with_all(fast)
    .with_all(lines.into_iter().map(|(name, points)| Series::new(Kind::Measured, name, points)))
}

/// `1–6, 13`
fn listed(labs: &[Lab]) -> String {
    let numbers: Vec<u32> = labs.iter().filter_map(|lab| lab.to_string().parse().ok()).collect();
    let runs = numbers.chunk_by(|a, b| a + 1 == *b).map(|run| match run {
        [one] => one.to_string(),
        [first, .., last] => format!("{first}–{last}"),
        [] => String::new(),
    });
    runs.collect::<Vec<_>>().join(", ")
}
