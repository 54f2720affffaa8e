//! `cargo lab race`: programs side by side.

use std::process::ExitCode;

use anyhow::Result;
use clap::Args;
use serde::Serialize;

use crate::clock::Ratio;
use crate::columns::Columns;
use crate::experiment::{Bound, Record};
use crate::files::Json;
use crate::fit::{Effort, Fit};
use crate::job::Job;
use crate::runner::Runner;
use crate::scene::OneScene;
use crate::subject::Programs;
use lab_kit::Kit;
use lab_kit::table::Table;

/// Race programs against each other on one scene
///
/// A program is `lab2`, `lab2:sorted`, or with its parameters `lab3:fork-join,t=2,padding=1`, where
/// t is threads and r ranks. `solution2:sorted` is the solution's. They take turns, round after
/// round; shown are the shortest take, the median, and how both compare with the first program's: decided,
/// if the median of the faster is less than the shortest take of the slower.
#[derive(Args)]
#[command(
    mut_arg("rounds", |rounds| rounds.default_value("5")),
    mut_arg("seconds", |seconds| seconds.default_value("30"))
)]
pub struct Options {
    #[command(flatten)]
    programs: Programs,
    #[command(flatten)]
    scene: OneScene,
    /// Threads, or ranks, of a program that does not say
    #[arg(short, default_value_t = 1, value_name = "WORKERS", value_parser = clap::value_parser!(u16).range(1..))]
    t: u16,
    #[command(flatten)]
    effort: Effort,
    #[command(flatten)]
    json: Json,
}

#[derive(Serialize)]
struct Row<'r> {
    #[serde(flatten)]
    record: &'r Record,
    ratio: Ratio,
}

#[derive(Serialize)]
struct Results<'r> {
    programs: Vec<Row<'r>>,
    streaming_bound: &'r [Bound],
}

/// Times the programs and prints the table.
pub fn run(kit: &Kit, options: Options) -> Result<ExitCode> {
    let (programs, hard) = options.programs.of_one_kind()?;
    let runner = Runner::build(kit, &programs)?;
    let scene = options.scene.scene(hard)?;
    let job = |program| Job { workers: options.t.into(), ..Job::new(program, scene.clone()) };
    let jobs = programs.into_iter().map(job).collect();
    let records = options.effort.run(&runner, jobs, Fit::Alike)?;
    let first = &records.records[0];
    let row = |record| Row { record, ratio: record.nanoseconds.over(first.nanoseconds) };
    let rows: Vec<Row> = records.records.iter().map(row).collect();
    let (steps, takes) =
        (count(first.job.steps, "step"), count(first.times.takes.len() as u64, "round"));
    println!("{}\nn = {}, {steps}, {takes}", table(&rows), first.job.scene.n());
    println!("{}", records.bounds_in_words());
    options.json.write(Results { programs: rows, streaming_bound: &records.bounds })?;
    Ok(ExitCode::SUCCESS)
}

fn count(count: u64, what: &str) -> String {
    format!("{count} {what}{}", if count == 1 { "" } else { "s" })
}

fn table(rows: &[Row]) -> Table {
    let is_first = |row: &Row| std::ptr::eq(row, &raw const rows[0]);
    Columns::of("nanoseconds per particle and step", |row: &Row| row.record.job.program.to_string())
        .text("workers", |row| row.record.job.all_workers().to_string())
        .times("", |row| row.record.nanoseconds)
        .compared(|row| (row.record.times.spread(), (!is_first(row)).then_some(row.ratio)))
        .table(rows)
}
