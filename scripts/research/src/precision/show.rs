//! The table and the work-precision diagram.

use super::Group;
use super::Point;
use lab_kit::table::{Table, three_digits};
use lab_measure::chart::{Axis, Chart, Series};

/// One n as a table.
pub(super) fn table(group: &Group) -> String {
    let mut table = Table::new([
        "* on the Pareto front",
        "rms error",
        "ms: min",
        "median",
        "force eval.",
        "energy drift, t = 1",
    ]);
    for point in &group.points {
        table.row([
            format!("{} {}", if point.on_front { "*" } else { " " }, point.program),
            format!("{:.2e}", point.rms_error),
            three_digits(1e3 * point.seconds.min()),
            three_digits(1e3 * point.seconds.median()),
            three_digits(point.force_evaluations),
            point.energy_drift.map_or_else(String::new, |drift| format!("{drift:.1e}")),
        ]);
    }
    format!(
        "n = {}, 100 official steps, one thread, {} takes\nThe reference's own error is {:.1e}\n\n\
         {table}",
        group.n,
        group.points.first().map_or(0, |point| point.seconds.takes()),
        group.reference_error
    )
}

/// All numbers, a line each.
pub(super) fn csv(groups: &[Group]) -> String {
    let mut text = String::from(
        "n,program,divide,rms_error,seconds_min,seconds_median,force_evaluations,energy_drift,front,reference_error\n",
    );
    for Group { reference_error, points, .. } in groups {
        for Point {
            program,
            n,
            divide,
            rms_error,
            seconds,
            force_evaluations,
            energy_drift,
            on_front,
        } in points
        {
            let (min, median) = (seconds.min(), seconds.median());
            let drift = energy_drift.map_or_else(String::new, |drift| format!("{drift:e}"));
            text += &format!(
                "{n},\"{program}\",{divide},{rms_error:e},{min:e},{median:e},{force_evaluations},{drift},{on_front},{reference_error:e}\n"
            );
        }
    }
    text
}

/// Error against seconds: a line for each variant that divides its step, one set of marks for all that do
/// not, and the front as a grey line.
pub(super) fn chart(group: &Group) -> Chart {
    let at = |point: &Point| (point.rms_error, point.seconds.min());
    let divides =
        |lab| group.points.iter().any(|p| p.program.lab == lab && !p.program.parameters.is_empty());
    let mut lines: Vec<(String, Vec<(f64, f64)>)> = Vec::new();
    for point in &group.points {
        // A lab that never divides its step takes the official one: what differs is the time.
        let name = match &point.program.variant {
            Some(variant) if divides(point.program.lab) => variant.clone(),
            _ => format!("lab {}, official step", point.program.lab),
        };
        match lines.iter_mut().find(|(known, _)| *known == name) {
            Some((_, points)) => points.push(at(point)),
            None => lines.push((name, vec![at(point)])),
        }
    }
    let front = group.points.iter().filter(|point| point.on_front).map(at).collect();
    Chart::new(
        format!("Run time against error, n = {}", group.n),
        Axis::log("rms error of the places at t = 0.05"),
        Axis::log("time of 100 official steps [s]"),
    )
    .with_all(lines.into_iter().map(|(name, points)| Series::measured(name, points)))
    .with(Series::guide("Pareto front", front))
}
