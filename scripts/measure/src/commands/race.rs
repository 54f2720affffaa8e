//! `cargo lab race`: programs side by side.

use std::process::ExitCode;

use anyhow::{Result, ensure};
use clap::Args;
use serde::Serialize;

use crate::clock::{Ratio, times_longer};
use crate::experiment::{Bound, Effort, Record};
use crate::files::Json;
use crate::job::Job;
use crate::runner::Runner;
use crate::scene::Discs;
use lab_kit::Kit;
use lab_kit::program::Program;
use lab_kit::table::{Table, three_digits};

/// Race programs against each other on one scene
///
/// A program is `lab2`, `lab2:sorted`, or with its parameters `lab3:fork-join,t=2,padding=1`, where
/// t is threads and r ranks. `solution2:sorted` is the solution's. They take turns, round after
/// round; shown are the shortest take, the median, and how both compare with the first program's.
#[derive(Args)]
#[command(
    mut_arg("rounds", |rounds| rounds.default_value("5")),
    mut_arg("seconds", |seconds| seconds.default_value("30"))
)]
pub struct Options {
    /// The programs, the one to compare with first
    #[arg(required = true, value_name = "PROGRAM")]
    programs: Vec<Program>,
    /// Race the solutions instead of your own work
    #[arg(long)]
    solution: bool,
    /// Number of particles [default: 100000; 10000 hard discs]
    #[arg(short, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    n: Option<u32>,
    #[command(flatten)]
    discs: Discs,
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
    let mut programs = options.programs.clone();
    for program in &mut programs {
        program.solution |= options.solution;
    }
    let hard = programs[0].is_hard();
    ensure!(
        programs.iter().all(|program| program.is_hard() == hard),
        "soft and hard discs cannot race: they are different problems"
    );
    let runner = Runner::build(kit, &programs)?;
    let scene = options.discs.scene(options.n.map(|n| n as usize), hard)?;
    let job = |program| Job { workers: options.t.into(), ..Job::new(program, scene.clone()) };
    let jobs: Vec<Job> = programs.into_iter().map(job).collect();
    let experiment = options.effort.experiment(&runner, jobs.clone());
    let records = experiment.calibrate_alike(&jobs)?.run()?;
    let first = &records.records[0];
    let rows: Vec<Row> = records
        .records
        .iter()
        .map(|record| Row { record, ratio: record.times.over(&first.times) })
        .collect();
    let (steps, takes) =
        (count(first.job.steps, "step"), count(first.times.takes() as u64, "round"));
    println!("{}\nn = {}, {steps}, {takes}", table(&rows), first.job.scene.n());
    println!("{}", records.bounds_in_words());
    options.json.write(Results { programs: rows, streaming_bound: &records.bounds })?;
    Ok(ExitCode::SUCCESS)
}

fn count(count: u64, what: &str) -> String {
    format!("{count} {what}{}", if count == 1 { "" } else { "s" })
}

fn table(rows: &[Row]) -> Table {
    let mut table = Table::new([
        "nanoseconds per particle and step",
        "workers",
        "min",
        "median",
        "spread",
        "ratio of min",
        "of median",
        "decided",
    ]);
    for (at, Row { record, ratio }) in rows.iter().enumerate() {
        table.row([
            record.job.program.to_string(),
            record.job.all_workers().to_string(),
            three_digits(record.nanoseconds.min),
            three_digits(record.nanoseconds.median),
            format!("{:.0} %", 100.0 * record.times.spread()),
            times_longer(ratio.of_minima),
            times_longer(ratio.of_medians),
            if at == 0 { "" } else { ratio.in_words() }.into(),
        ]);
    }
    table
}
