//! The tables, and the chart of pairs that meet.

use super::trials::{Column, Observable, Trial};
use super::verdict::{Cell, Verdict};
use super::{Pairs, Row};
use lab_kit::table::Table;
use lab_measure::chart::{Axis, Chart, Kind, Series};

/// All tables, what their marks mean, and what failed.
pub(super) fn tables(trials: &[Trial], rows: &[Row]) -> String {
    let columns = || trials.iter().flat_map(|trial| &trial.columns);
    let mut table = Table::new(std::iter::once("").chain(columns().map(|column| column.head)));
    for row in rows {
        table.row(std::iter::once(row.program.to_string()).chain(row.cells.iter().map(cell)));
    }
    let mut text = format!(
        "{table}\nok: passes  ~: a limit of the method  -: its step is built in  FAIL: a mistake\n\n\
         What a column shows, how much of it passes, and the section of the chapter\n\
         'Accurate' that explains more:\n"
    );
    for trial in trials {
        for column in &trial.columns {
            let section = column.section.map(|section| format!(", '{section}'"));
            let (head, what, good) = (column.head, meaning(trial, column), column.good);
            let (name, steps) = (trial.name, trial.steps);
            let section = section.unwrap_or_default();
            text += &format!(
                "{head:<12}  {name}, {steps} steps{section}\n              {what}; {good:e}\n"
            );
        }
    }
    text += &format!("\n{}", refusals(rows));
    for row in rows {
        for cell in &row.cells {
            if let Verdict::Fails(why) = &cell.verdict {
                text += &format!("FAIL  {}, {}: {why}\n", row.program, cell.column);
            }
        }
    }
    let count = |wanted: fn(&Verdict) -> bool| {
        rows.iter().flat_map(|row| &row.cells).filter(|cell| wanted(&cell.verdict)).count()
    };
    let inputs = || rows.iter().flat_map(|row| &row.inputs);
    text += &format!(
        "{} cells pass, {} show a limit of the method, {} fail;\n{} of {} bad inputs are refused\n",
        count(|v| *v == Verdict::Passes),
        count(|v| matches!(v, Verdict::Limit(_))),
        count(|v| matches!(v, Verdict::Fails(_))),
        inputs().filter(|input| input.refused).count(),
        inputs().count(),
    );
    text
}

fn meaning(trial: &Trial, column: &Column) -> &'static str {
    match trial.observable {
        Observable::HeadOn { .. } if column.head.starts_with("through") => {
            "least relative speed that lets a pair through, 0 for none"
        }
        Observable::HeadOn { .. } => "greatest change of a pair's energy",
        Observable::Energy => "change of all energy",
        Observable::Off => "distance from where the step should go, in cutoffs",
        Observable::Shifted => "distance from the same in a small box, in cutoffs",
        Observable::Inside => "all particles finite and inside",
    }
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

/// What was said to bad input: the first program's words, and which programs did not refuse.
fn refusals(rows: &[Row]) -> String {
    let mut table = Table::new(["bad input", "refused by", &format!("{:<36}", "what was said")]);
    let mut faults = String::new();
    for k in 0..rows.first().map_or(0, |row| row.inputs.len()) {
        let inputs = || rows.iter().map(|row| &row.inputs[k]);
        let well = inputs().filter(|input| input.refused).count();
        let said = inputs().find(|input| input.refused).map_or("", |input| &input.said);
        let said: String = said.trim_start_matches("bad.txt: ").chars().take(36).collect();
        let what = rows[0].inputs[k].input;
        table.row([what.to_owned(), format!("{well} of {}", rows.len()), format!("{said:<36}")]);
        for row in rows.iter().filter(|row| !row.inputs[k].refused) {
            faults += &format!("FAIL  {}, {what}: {}\n", row.program, row.inputs[k].said);
        }
    }
    format!("{table}\n{faults}")
}

/// What pairs gain when they meet head on, a line for each way to go through time.
pub(super) fn chart(rows: &[Pairs]) -> Chart {
    // A program, how many are alike, and their line.
    let mut lines = Vec::<(String, usize, Vec<_>)>::new();
    for row in rows {
        let points: Vec<_> =
            row.met.iter().map(|met| (f64::from(met.speed), met.worst.abs())).collect();
        // Programs that take the same step have the same line.
        let same = |known: &[(f64, f64)]| {
            known.iter().zip(&points).all(|(a, b)| (a.1 / b.1 - 1.0).abs() < 1e-3)
        };
        match lines.iter_mut().find(|(.., known)| same(known)) {
            Some((_, others, _)) => *others += 1,
            None => lines.push((row.program.variant.clone().unwrap_or_default(), 0, points)),
        }
    }
    Chart::new(
        "Two that meet head on, official time step",
        Axis::linear("relative speed"),
        Axis::log("greatest change of the pair's energy"),
    )
    .with_all(lines.into_iter().map(|(name, others, points)| {
        let name = if others == 0 { name } else { format!("{name} and {others} others") };
        Series::new(Kind::Measured, name, points)
    }))
}
