//! `cargo lab limits`: how close programs are to the least times that their counts allow.

mod rows;
mod takes;

use std::path::PathBuf;

use anyhow::{Context, Result, ensure};
use clap::Args;
use lab_kit::Kit;
use lab_kit::program::Program;
use serde::{Deserialize, Serialize};

use super::count;
use crate::bounds::{Costs, bandwidth};
use crate::chart::{Axis, Chart, Kind, Series, Sheet};
use crate::experiment::in_turns;
use crate::numbers::{DataFile, Files};
use crate::runner::Runner;
use rows::{Row, table};
use takes::{Counted, Take};

/// Show how far programs are from what their counts allow
///
/// Reads the files of 'cargo lab count --json'. Measures the cost, on this machine, of an
/// instruction, a mispredicted branch and a miss. Times the programs over the steps that were
/// counted: with one worker, and with one for each core if they can use several. The least time is
/// the time of the instructions, at the core's greatest rate, or the time of streaming the lines
/// that miss the first-level cache, whichever is longer.
#[derive(Args)]
pub struct Options {
    /// Files that 'cargo lab count --json' wrote
    #[arg(required = true, value_name = "COUNTS")]
    counts: Vec<PathBuf>,
    /// Number of time steps that are timed
    #[arg(long, default_value_t = 100, value_name = "STEPS", value_parser = clap::value_parser!(u64).range(1..))]
    steps: u64,
    /// Number of takes of each run; the shortest one counts
    #[arg(long, default_value_t = 4, value_name = "ROUNDS", value_parser = clap::value_parser!(u16).range(1..))]
    rounds: u16,
    #[command(flatten)]
    pub(in crate::commands) files: Files,
}

#[derive(Deserialize, Serialize)]
pub(super) struct Results {
    costs: Costs,
    programs: Vec<Row>,
}

impl Options {
    pub(in crate::commands) fn draw(&self, results: Results) -> Result<Sheet> {
        let most = 1.0 / results.costs.operation;
        let flops = results.roof("Operations", "operations", most, |row| row.operations);
        let most = 1.0 / results.costs.instruction;
        let all = results.roof("Instructions", "instructions", most, |row| Some(row.instructions));
        Ok(vec![vec![flops, all]])
    }
}

pub(super) fn run(kit: &Kit, options: Options) -> Result<()> {
    let mut counted = Vec::new();
    let mut caches = None;
    for file in &options.counts {
        let file = count::Results::deserialize(DataFile::read(file)?.results)?;
        ensure!(*caches.get_or_insert(file.caches) == file.caches, "counted with other caches");
        for row in file.programs {
            let shared = shares_work(kit, &row.job.program)?;
            counted.push(Counted { row, after: file.after, shared });
        }
    }
    counted.sort_by_key(|run| run.row.job.program.lab);
    let programs: Vec<Program> = counted.iter().map(|run| run.row.job.program.clone()).collect();
    let runner = Runner::build(kit, &programs)?;
    let costs = Costs::measure(caches.context("no counts")?);
    let takes = in_turns(&counted, options.rounds.into(), Counted::name, |run| {
        run.take(&runner, options.steps)
    })?;
    let mut rows: Vec<Row> = Vec::new();
    for (run, takes) in counted.iter().zip(takes) {
        let least = takes.into_iter().reduce(Take::least).context("no rounds")?;
        rows.push(Row::new(run, least, &costs, &runner, options.steps)?);
    }
    println!("{}\n{}", table(&rows), costs.in_words());
    options.files.write(Results { costs, programs: rows }, |shown| options.draw(shown))
}

/// Whether the workers of a program share its work, according to the lab's facts.
fn shares_work(kit: &Kit, program: &Program) -> Result<bool> {
    let variants = kit.facts(program.lab)?.variants;
    let facts = variants.iter().find(|facts| Some(&facts.name) == program.variant.as_ref());
    Ok(facts.is_some_and(|facts| !facts.serial))
}

impl Results {
    /// Plots work per nanosecond against work per byte: a mark for each program, and the machine's
    /// maximum.
    fn roof(&self, title: &str, what: &str, peak: f64, work: fn(&Row) -> Option<f64>) -> Chart {
        let mut chart = Chart::new(
            title,
            Axis::log(format!("{what} per byte")),
            Axis::log(format!("{what} per ns")),
        );
        let streaming = self.programs.iter().max_by_key(|row| row.n).map(|row| row.streaming);
        let streams = bandwidth(streaming.unwrap_or(f64::NAN));
        let mut low = peak / streams;
        let mut high = peak / streams;
        for of_lab in self.programs.chunk_by(|a, b| a.program.lab == b.program.lab) {
            let mut points = Vec::new();
            for row in of_lab {
                points.extend(work(row).map(|work| (work / row.bytes, work / row.time)));
            }
            low = points.iter().fold(low, |low, point| low.min(point.0));
            high = points.iter().fold(high, |high, point| high.max(point.0));
            let lab = format!("lab {}", of_lab[0].program.lab);
            chart = chart.with(Series::new(Kind::Apart, lab, points));
        }
        let roof = vec![(low, low * streams), (peak / streams, peak), (high, peak)];
        chart.with(Series::new(Kind::Model, "the roof: one core, measured", roof))
    }
}
