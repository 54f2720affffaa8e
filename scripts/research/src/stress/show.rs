//! The tables, the record and the chart of pairs that meet.

use serde_json::{Value, json};

use super::Row;
use super::inputs::BAD;
use super::trials::{Column, Look, Trial};
use super::verdict::{Cell, Verdict};
use lab_kit::table::Table;
use lab_measure::chart::{Axis, Chart, Series};

/// Columns of one table, so that it fits a page.
const WIDTH: usize = 6;

/// All tables, what their marks mean, and what failed.
pub(super) fn tables(trials: &[Trial], rows: &[Row]) -> String {
    let columns: Vec<_> = trials.iter().flat_map(|trial| trial.columns).collect();
    let mut text = String::new();
    for from in (0..columns.len()).step_by(WIDTH) {
        let to = (from + WIDTH).min(columns.len());
        let heads = columns[from..to].iter().map(|column| column.head);
        let mut table = Table::new(std::iter::once("").chain(heads));
        for row in rows {
            let cells = row.cells[from..to].iter().map(cell);
            table.row(std::iter::once(row.name.clone()).chain(cells));
        }
        text += &format!("{table}\n");
    }
    text += "ok: passes   ~: a limit of the method   -: its step is built in   FAIL: a mistake\n";
    text += "What a column shows, how much of it passes, and the section of chapter 10, Accurate, that \
             explains more:\n";
    for trial in trials {
        for column in trial.columns {
            let section = column.section.map(|section| format!(", '{section}'"));
            let (good, section) = (column.good, section.unwrap_or_default());
            text +=
                &format!("  {:<12}  {}; {good:e}{section}\n", column.head, meaning(trial, column));
        }
    }
    text += &format!("\n{}", refusals(rows));
    for row in rows {
        for (column, cell) in columns.iter().zip(&row.cells) {
            if let Verdict::Fails(why) = &cell.verdict {
                text += &format!("FAIL  {}, {}: {why}\n", row.name, column.head);
            }
        }
    }
    let count = |wanted: fn(&Verdict) -> bool| {
        rows.iter().flat_map(|row| &row.cells).filter(|cell| wanted(&cell.verdict)).count()
    };
    let refused = rows.iter().flat_map(|row| &row.refused);
    let (bad, well) = (refused.clone().count(), refused.filter(|said| said.is_ok()).count());
    text += &format!(
        "{} cells pass, {} show a limit of the method, {} fail; {well} of {bad} bad inputs are \
         refused\n",
        count(|v| *v == Verdict::Passes),
        count(|v| matches!(v, Verdict::Limit(_))),
        count(|v| matches!(v, Verdict::Fails(_))),
    );
    text
}

fn meaning(trial: &Trial, column: &Column) -> String {
    let what = match trial.look {
        Look::HeadOn { .. } if column.head.starts_with("through") => {
            "least relative speed that lets a pair through, 0 for none"
        }
        Look::HeadOn { .. } => "greatest change of a pair's energy",
        Look::Energy => "change of all energy",
        Look::Off => "distance from the method's step, in cutoffs",
        Look::Shifted => "distance from the same in a small box, in cutoffs",
        Look::Inside => "everybody finite and inside",
    };
    format!("{}, {} steps: {what}", trial.name, trial.steps)
}

fn cell(cell: &Cell) -> String {
    let figure = cell.figure.map(number).unwrap_or_default();
    match cell.verdict {
        Verdict::Passes => format!("{figure} ok"),
        Verdict::Limit(_) => format!("{figure} ~ "),
        Verdict::Unable(_) => "-   ".into(),
        Verdict::Fails(_) => "FAIL".into(),
    }
}

fn number(value: f64) -> String {
    if value == 0.0 || (value.fract() == 0.0 && value.abs() < 100.0) {
        format!("{value}")
    } else {
        format!("{value:.1e}")
    }
}

/// What was said to bad input: the first program's words, and who did not refuse.
fn refusals(rows: &[Row]) -> String {
    let mut table = Table::new(["bad input", "refused by", "what was said"]);
    let mut faults = String::new();
    for (k, bad) in BAD.iter().enumerate() {
        let well = rows.iter().filter(|row| row.refused[k].is_ok()).count();
        let said = rows.iter().find_map(|row| row.refused[k].as_ref().ok());
        let said: String = said.cloned().unwrap_or_default().chars().take(70).collect();
        table.row([bad.what.to_owned(), format!("{well} of {}", rows.len()), said]);
        for row in rows {
            if let Err(why) = &row.refused[k] {
                faults += &format!("FAIL  {}, {}: {why}\n", row.name, bad.what);
            }
        }
    }
    format!("{table}\n{faults}")
}

/// Everything, cell by cell.
pub(super) fn results(trials: &[Trial], rows: &[Row]) -> Value {
    let columns: Vec<_> = trials
        .iter()
        .flat_map(|trial| trial.columns.iter().map(move |column| (trial, column)))
        .collect();
    let row = |row: &Row| {
        let cells = columns.iter().zip(&row.cells).map(|((trial, column), cell)| {
            let (verdict, why) = match &cell.verdict {
                Verdict::Passes => ("passes", None),
                Verdict::Limit(section) => ("limit", Some((*section).to_owned())),
                Verdict::Unable(why) => ("unable", Some((*why).to_owned())),
                Verdict::Fails(why) => ("fails", Some(why.clone())),
            };
            json!({
                "trial": trial.name, "column": column.head, "steps": trial.steps,
                "figure": cell.figure, "verdict": verdict, "why": why,
            })
        });
        let met = row.met.iter().map(|met| {
            json!({ "relative_speed": met.speed, "worst_gain": met.worst, "mean_gain": met.mean, "share_through": met.through })
        });
        let refused = BAD.iter().zip(&row.refused).map(|(bad, said)| {
            json!({ "input": bad.what, "refused": said.is_ok(),
                    "said": said.as_ref().unwrap_or_else(|why| why) })
        });
        json!({
            "program": row.name, "cells": cells.collect::<Vec<_>>(),
            "head_on": met.collect::<Vec<_>>(), "inputs": refused.collect::<Vec<_>>(),
        })
    };
    json!(rows.iter().map(row).collect::<Vec<_>>())
}

/// What pairs gain when they meet head on, a line for each way to go through time.
pub(super) fn charts(rows: &[Row]) -> Vec<Chart> {
    let mut lines: Vec<(String, Vec<(f64, f64)>)> = Vec::new();
    for row in rows {
        let points: Vec<_> =
            row.met.iter().map(|met| (f64::from(met.speed), met.worst.abs())).collect();
        // Whoever takes the same step has the same line.
        let same = |known: &[(f64, f64)]| {
            known.iter().zip(&points).all(|(a, b)| (a.1 / b.1 - 1.0).abs() < 1e-3)
        };
        match lines.iter_mut().find(|(_, known)| same(known)) {
            Some((name, _)) if !name.ends_with('…') => *name += ", …",
            Some(_) => {}
            None => {
                let name = row.name.split_once(':').map_or(&*row.name, |(_, variant)| variant);
                lines.push((name.to_owned(), points));
            }
        }
    }
    let chart = Chart::new(
        "Two that meet head on, official time step",
        Axis::linear("relative speed"),
        Axis::log("greatest change of the pair's energy"),
    );
    vec![chart.with_all(lines.into_iter().map(|(name, points)| Series::measured(name, points)))]
}
