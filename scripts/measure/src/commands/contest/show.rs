//! The tables and the plane of run time and error.

use lab_kit::table::three_digits;
use oracle::contest::Kind;

use super::entry::Entry;
use super::ranking::{Ranking, unranked};
use crate::chart::{Axis, Chart, Kind as Look, Series};
use crate::clock::Span;
use crate::columns::Columns;
use crate::commands::precision::group::front;

struct Row<'e> {
    name: String,
    entry: &'e Entry,
}

/// Formats tables of all entries' places, results on each kind of scene, and faults.
pub(super) fn tables(entries: &[Entry], landmarks: &[Entry]) -> String {
    let all = &*entries.iter().chain(landmarks).collect::<Vec<&Entry>>();
    let mut rows = Vec::new();
    for (at, entry) in all.iter().enumerate() {
        let star = if at < entries.len() { "" } else { " *" };
        rows.push(Row { name: entry.name() + star, entry });
    }
    let mut places = Columns::of("all kinds", |row: &Row| row.name.clone())
        .perhaps("time", |row| row.entry.time.map(range))
        .perhaps("error", |row| row.entry.error.map(range))
        .number("instructions", |row| row.entry.instructions);
    for ranking in Ranking::ALL {
        places = places.text(ranking.name(), move |row| place(ranking, row.entry, all));
    }
    let mut kinds = Columns::of("time / error", |row: &Row| row.name.clone());
    for kind in Kind::ALL {
        kinds = kinds.perhaps(kind.name(), move |row| {
            let time = three_digits(row.entry.times(kind)?.median);
            Some(format!("{time} / {}", three_digits(row.entry.errors(kind)?.median)))
        });
    }
    let mut text = format!("{}\n{}", places.table(&rows), kinds.table(&rows));
    for entry in all {
        if let Some(why) = unranked(entry) {
            text += &format!("\nnot ranked: {}: {why}", entry.name());
        }
    }
    text + "\nTime and error: the best and the median of the rounds. 1 is the time of solution2:sorted, and the error of\n\
            the official step. A place with = is shared.\n\
            * an engine of the kit, measured for the book on its machine; solution14:entry is the starter"
}

/// Formats a place, with `=` if it is shared.
fn place(ranking: Ranking, entry: &Entry, all: &[&Entry]) -> String {
    let Some(own) = ranking.place(entry, all) else { return "-".into() };
    let alike = all.iter().filter(|other| ranking.place(other, all) == Some(own)).count();
    format!("{own}{}", if alike > 1 { "=" } else { "" })
}

/// Formats the least and the median of the rounds.
fn range(span: Span) -> String {
    format!("{} {}", three_digits(span.min), three_digits(span.median))
}

/// Plots run time against error, with the front that no entry beats.
pub(super) fn chart(entries: &[Entry], landmarks: &[Entry]) -> Chart {
    let all = entries.iter().chain(landmarks).filter(|entry| entry.faults.is_empty());
    let points: Vec<(f64, f64)> = all.filter_map(point).collect();
    let costs: Vec<(f64, f64)> = points.iter().map(|(error, time)| (*time, *error)).collect();
    let best = points.iter().zip(front(&costs)).filter(|(_, on_front)| *on_front);
    let mut chart = Chart::new(
        "The contest: run time against error",
        Axis::log("error, in errors of the official step"),
        Axis::log("time, in times of sorted"),
    )
    .labelled_directly()
    .with(Series::new(Look::Guide, "front", best.map(|(point, _)| *point).collect()));
    for entry in landmarks {
        chart = chart.with(series(Look::Behind, entry));
    }
    for entry in entries {
        chart = chart.with(series(Look::Apart, entry));
    }
    chart
}

/// Returns an entry's error and time; `None` if a kind is missing.
fn point(entry: &Entry) -> Option<(f64, f64)> {
    Some((entry.error?.median, entry.time?.median))
}

/// Makes the mark of an entry. The kit's engines are named without their lab.
fn series(look: Look, entry: &Entry) -> Series {
    let program = entry.name();
    let short = program.split_once(':').filter(|_| entry.program.solution);
    let out = if entry.faults.is_empty() { "" } else { " (out)" };
    let name = format!("{}{out}", short.map_or(&*program, |(_, variant)| variant));
    Series::new(look, name, point(entry).into_iter().collect())
}
