//! The tables, and the chart of head-on pairs.

use lab_kit::table::Table;

use super::judge::{Cell, Pairs, Row, Verdict};
use super::trials::{Column, Observable, Trial};
use crate::chart::{Axis, Chart, Kind, Series};

const LEGEND: &str = "
ok: passes  ~: a limit of the method  -: its step is built in  FAIL: a mistake

What a column shows, how much of it passes, and the section of the chapter
'Accurate' that explains more:
";

/// Formats all tables, the meaning of their marks, and the failures.
pub(super) fn tables(trials: &[Trial], rows: &[Row]) -> String {
    let columns = trials.iter().flat_map(|trial| &trial.columns);
    let mut table = Table::new(std::iter::once("").chain(columns.map(|column| column.head)));
    for row in rows {
        table.row(std::iter::once(row.program.to_string()).chain(row.cells.iter().map(cell)));
    }
    let mut text = format!("{table}{LEGEND}");
    for trial in trials {
        for column in &trial.columns {
            let section = column.section.map_or(String::new(), |name| format!(", '{name}'"));
            let Trial { name, steps, .. } = trial;
            let Column { head, good, .. } = column;
            let what = meaning(trial, column);
            text += &format!(
                "{head:<12}  {name}, {steps} steps{section}\n              {what}; {good:e}\n"
            );
        }
    }
    text += &format!("\n{}", refusals(rows));
    let mut passed = 0;
    let mut limits = 0;
    let mut failed = 0;
    for row in rows {
        for cell in &row.cells {
            match &cell.verdict {
                Verdict::Passes => passed += 1,
                Verdict::Limit(_) => limits += 1,
                Verdict::Unable(_) => {}
                Verdict::Fails(why) => {
                    failed += 1;
                    text += &format!("FAIL  {}, {}: {why}\n", row.program, cell.column);
                }
            }
        }
    }
    let inputs = rows.iter().flat_map(|row| &row.inputs);
    let refused = inputs.clone().filter(|input| input.refused).count();
    text + &format!(
        "{passed} cells pass, {limits} show a limit of the method, {failed} fail;\n\
         {refused} of {} bad inputs are refused\n",
        inputs.count()
    )
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

/// Formats the answers to bad inputs: a message for each, and the programs that accepted the input.
fn refusals(rows: &[Row]) -> String {
    let mut table = Table::new(["bad input", "refused by", &format!("{:<36}", "message")]);
    let mut faults = String::new();
    for k in 0..rows.first().map_or(0, |row| row.inputs.len()) {
        let what = rows[0].inputs[k].input;
        let mut well = Vec::new();
        for row in rows {
            let input = &row.inputs[k];
            if input.refused {
                well.push(input.answer.trim_start_matches("bad.txt: "));
            } else {
                faults += &format!("FAIL  {}, {what}: {}\n", row.program, input.answer);
            }
        }
        let message: String = well.first().unwrap_or(&"").chars().take(36).collect();
        let refused = format!("{} of {}", well.len(), rows.len());
        table.row([what.to_owned(), refused, format!("{message:<36}")]);
    }
    format!("{table}\n{faults}")
}

/// A line of the chart, named after the first program that has it.
struct Line {
    name: String,
    /// Number of other programs with this line.
    others: usize,
    points: Vec<(f64, f64)>,
}

/// Plots the energy that pairs gain in a head-on collision against their relative speed. Programs
/// with the same points share a line.
pub(super) fn chart(rows: &[Pairs]) -> Chart {
    let mut lines: Vec<Line> = Vec::new();
    for row in rows {
        let points = row.met.iter().map(|met| (f64::from(met.speed), met.worst.abs())).collect();
        match lines.iter_mut().find(|line| is_same(&line.points, &points)) {
            Some(line) => line.others += 1,
            None => {
                let name = row.program.variant.clone().unwrap_or_default();
                lines.push(Line { name, others: 0, points });
            }
        }
    }
    let mut chart = Chart::new(
        "Two that meet head on, official time step",
        Axis::linear("relative speed"),
        Axis::log("greatest change of the pair's energy"),
    );
    for Line { mut name, others, points } in lines {
        if others > 0 {
            name += &format!(" and {others} others");
        }
        chart = chart.with(Series::new(Kind::Measured, name, points));
    }
    chart
}

fn is_same(a: &[(f64, f64)], b: &Vec<(f64, f64)>) -> bool {
    a.iter().zip(b).all(|(a, b)| (a.1 / b.1 - 1.0).abs() < 1e-3)
}
