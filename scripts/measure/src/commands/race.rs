//! `cargo lab race`: times of programs that take turns.

use anyhow::Result;
use clap::Args;
use serde::Serialize;

use crate::clock::Ratio;
use crate::columns::Columns;
use crate::experiment::{Bound, Timing};
use crate::fit::{Effort, Fit};
use crate::job::Job;
use crate::numbers::Json;
use crate::runner::Runner;
use crate::scene_options::OneScene;
use crate::subject::Programs;
use lab_kit::Kit;
use lab_kit::table::Table;

/// Race programs against each other on one scene
///
/// A program is `lab2`, `lab2:sorted`, or with parameters `lab3:fork-join,t=2,padding=1`, where t
/// is the number of threads and r the number of ranks. `solution2:sorted` is the solution's
/// program. The programs take turns, round after round. The table shows the shortest take, the
/// median, and the ratio of both to the first program. A ratio is decided if the median of the
/// faster program is less than the shortest take of the slower one.
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
    /// Number of threads, or ranks, of a program that does not set it
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
    timing: &'r Timing,
    ratio: Ratio,
}

#[derive(Serialize)]
struct Results<'r> {
    programs: Vec<Row<'r>>,
    streaming_bound: &'r [Bound],
}

pub(super) fn run(kit: &Kit, options: Options) -> Result<()> {
    let programs = options.programs.of_one_kind()?;
    let runner = Runner::build(kit, &programs)?;
    let scene = options.scene.scene(programs[0].is_hard())?;
    let like = Job { workers: options.t.into(), ..Job::new(programs[0].clone(), scene) };
    let jobs = programs.into_iter().map(|program| Job { program, ..like.clone() });
    let timings = options.effort.run(&runner, jobs.collect(), Fit::Alike)?;
    let first = &timings.timings[0];
    let mut rows = Vec::new();
    for timing in &timings.timings {
        rows.push(Row { timing, ratio: timing.nanoseconds.over(first.nanoseconds) });
    }
    println!("{}", table(&rows));
    let steps = count(first.job.steps, "step");
    let rounds = count(first.times.takes.len() as u64, "round");
    println!("n = {}, {steps}, {rounds}", first.job.scene.n());
    println!("{}", timings.bounds_in_words());
    options.json.write(Results { programs: rows, streaming_bound: &timings.bounds })
}

fn count(count: u64, what: &str) -> String {
    format!("{count} {what}{}", if count == 1 { "" } else { "s" })
}

fn table(rows: &[Row]) -> Table {
    Columns::of("nanoseconds per particle and step", |row: &Row| row.timing.job.program.to_string())
        .text("workers", |row| row.timing.job.all_workers().to_string())
        .times("", |row| row.timing.nanoseconds)
        .compared(
            |row| row.timing.times.spread(),
            |row| (!std::ptr::eq(row, &raw const rows[0])).then_some(row.ratio),
        )
        .table(rows)
}
