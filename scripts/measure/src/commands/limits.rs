//! `cargo lab limits`: how far programs are from what their counts allow.

use std::path::PathBuf;
use std::process::ExitCode;

use anyhow::{Context, Result, ensure};
use clap::Args;
use lab_kit::program::Program;
use lab_kit::table::Table;
use lab_kit::{Discs, Kit, machine};
use lab_machine::streaming;
use serde::{Deserialize, Serialize};

use super::count;
use crate::chart::{Axis, Chart, Kind, Series, Sheet};
use crate::columns::Columns;
use crate::experiment::in_turns;
use crate::files::{Files, Report};
use crate::job::Job;
use crate::limits::{Bounds, Costs, bandwidth, bytes};
use crate::runner::Runner;

/// Say how far programs are from what their counts allow
///
/// Takes what 'cargo lab count --json' wrote, measures in seconds what an instruction, a mispredicted branch and a
/// miss cost on this machine, and times the programs that were counted, from the step on from which they were: with
/// one worker, and with one for each core where they can. The least time is that of the instructions, as many at
/// once as the core can, or that of streaming as many lines as miss the first-level cache, if that is longer.
#[derive(Args)]
pub struct Options {
    /// Files that 'cargo lab count --json' wrote
    #[arg(required = true, value_name = "COUNTS")]
    counts: Vec<PathBuf>,
    /// Time steps that are timed
    #[arg(long, default_value_t = 100, value_name = "STEPS", value_parser = clap::value_parser!(u64).range(1..))]
    steps: u64,
    /// How often each run is repeated; the shortest counts
    #[arg(long, default_value_t = 4, value_name = "ROUNDS", value_parser = clap::value_parser!(u16).range(1..))]
    rounds: u16,
    #[command(flatten)]
    pub(super) files: Files,
}

/// Multiplications, additions, divisions and roots that the formulas need: for the distance of two particles, for the
/// force on one of them, and for a particle's move.
const DISTANCE: f64 = 5.0;
const FORCE: f64 = 9.0;
const MOVE: f64 = 8.0;

/// All numbers.
#[derive(Deserialize, Serialize)]
pub struct Results {
    costs: Costs,
    programs: Vec<Row>,
}

#[derive(Deserialize, Serialize)]
struct Row {
    program: Program,
    n: usize,
    /// Nanoseconds per particle and step: measured, and by the counts.
    time: f64,
    bounds: Bounds,
    least: f64,
    /// What part of the time the least one is, and what holds the program.
    reached: f64,
    held_by: String,
    /// Of streaming all particles once.
    streaming: f64,
    instructions: f64,
    /// That come into the first-level cache.
    bytes: f64,
    /// Operations of floating point; none where no pairs are counted.
    operations: Option<f64>,
    all_cores: Option<Shared>,
}

/// A run with a worker for each core.
#[derive(Deserialize, Serialize)]
struct Shared {
    time: f64,
    /// What part of its time an even share of one worker's is.
    reached: f64,
    /// Parts of the time, mean of the workers, that it counts.
    waiting: Option<f64>,
    messages: Option<f64>,
}

/// What was counted, from which step on, and whether more workers share its work.
struct Counted {
    row: count::Row,
    after: u64,
    shared: bool,
}

impl Options {
    pub(super) fn draw(&self, results: Results) -> Result<Sheet> {
        let (instructions, operations) = results.costs.peaks();
        let flops = results.roof("Operations", "operations", operations, |row| row.operations);
        let all = results
            .roof("Instructions", "instructions", instructions, |row| Some(row.instructions));
        Ok(vec![vec![flops, all]])
    }
}

/// Measures, prints, writes.
pub fn run(kit: &Kit, options: Options) -> Result<ExitCode> {
    let (mut counted, mut caches) = (Vec::new(), None);
    for file in &options.counts {
        let file = count::Results::deserialize(Report::read(file)?.results)?;
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
    let name = |run: &Counted| run.row.job.program.to_string();
    // On one worker the seconds until counting began and in all, on all cores the same, and the streaming bound.
    let takes = in_turns(&counted, options.rounds.into(), name, |run| {
        let mut take = [f64::NAN; 5];
        for (at, workers) in [1, machine::cores()].into_iter().enumerate() {
            if workers == 1 || run.shared {
                take[2 * at] = runner.run(&run.job(workers, run.after))?.seconds;
                take[2 * at + 1] =
                    runner.run(&run.job(workers, run.after + options.steps))?.seconds;
            }
        }
        take[4] = streaming::nanoseconds(run.n(), 1);
        Ok(take)
    })?;
    let mut rows: Vec<Row> = Vec::new();
    for (run, takes) in counted.iter().zip(&takes) {
        let least = |at: usize| takes.iter().map(|take| take[at]).fold(f64::INFINITY, f64::min);
        let per = 1e9 / (run.n() as f64 * options.steps as f64);
        let (time, on_all) = (per * (least(1) - least(0)), per * (least(3) - least(2)));
        let mut row = Row::new(run, time, least(4), &costs);
        row.operations = operations(&runner, &run.job(1, run.after + options.steps))?;
        let all_cores = || Shared::new(&runner, run, on_all, time);
        row.all_cores = run.shared.then(all_cores).transpose()?;
        rows.push(row);
    }
    println!("{}\n{}", table(&rows), costs.in_words());
    options.files.write(Results { costs, programs: rows }, |shown| options.draw(shown))?;
    Ok(ExitCode::SUCCESS)
}

impl Counted {
    fn n(&self) -> usize {
        self.row.job.scene.n()
    }

    fn job(&self, workers: usize, steps: u64) -> Job {
        Job { steps, workers, ..self.row.job.clone() }
    }
}

impl Row {
    fn new(run: &Counted, time: f64, streaming: f64, costs: &Costs) -> Self {
        let counts = run.row.counts();
        let bounds = Bounds::new(counts, costs, streaming);
        Self {
            program: run.row.job.program.clone(),
            n: run.n(),
            time,
            bounds,
            least: bounds.least(),
            reached: bounds.least() / time,
            held_by: bounds.holding(time).into(),
            streaming,
            instructions: counts[0],
            bytes: bytes(counts),
            operations: None,
            all_cores: None,
        }
    }
}

/// Whether more workers share its work, by the words of its lab.
fn shares_work(kit: &Kit, program: &Program) -> Result<bool> {
    let variants = kit.facts(program.lab)?.variants;
    let facts = variants.into_iter().find(|facts| Some(&facts.name) == program.variant.as_ref());
    let alone = |facts: &str| facts.split([';', ':']).any(|words| words.trim() == "one thread");
    Ok(facts.is_some_and(|facts| !alone(&facts.scaling)))
}

/// Operations of floating point per particle and step: what the formulas need for the pairs that a run counts.
fn operations(runner: &Runner, job: &Job) -> Result<Option<f64>> {
    if job.program.discs != Discs::Soft {
        return Ok(None);
    }
    let outcome = runner.run(&Job { statistics: true, ..job.clone() })?;
    let listed = outcome.counters.get("pair tests per particle and step").copied();
    let of = |pairs: crate::job::Statistics| {
        DISTANCE * listed.unwrap_or(pairs.pair_tests) + FORCE * pairs.neighbours + MOVE
    };
    Ok(outcome.statistics.map(of))
}

impl Shared {
    fn new(runner: &Runner, run: &Counted, time: f64, alone: f64) -> Result<Self> {
        let job = run.job(machine::cores(), run.after + run.row.job.steps);
        // Ranks say what they do if they record it, and not all can.
        let recorded = job.program.has_ranks().then(|| Job { events: true, ..job.clone() });
        let recorded = recorded.and_then(|job| runner.run(&job).ok());
        let outcome = recorded.map_or_else(|| runner.run(&job), Ok)?;
        let part = |what: &str| {
            let of = |name: &str| name.contains(what) && name.contains("[s]");
            let parts = outcome.counters.iter().filter(|(name, _)| of(name));
            let sum = parts.map(|(_, seconds)| *seconds).reduce(|a, b| a + b);
            sum.map(|sum| sum / job.workers as f64 / outcome.seconds)
        };
        let (waiting, messages) = (part("wait"), part("communicate"));
        let reached = alone / job.workers as f64 / time;
        Ok(Self { time, reached, waiting, messages })
    }
}

impl Results {
    /// Work per byte and per nanosecond: a mark for each program, below what the machine allows.
    fn roof(&self, title: &str, what: &str, peak: f64, work: fn(&Row) -> Option<f64>) -> Chart {
        let of = |row: &Row| Some((work(row)? / row.bytes, work(row)? / row.time));
        let mut labs: Vec<_> = self.programs.iter().map(|row| row.program.lab).collect();
        labs.sort();
        labs.dedup();
        let series = labs.into_iter().map(|lab| {
            let rows = self.programs.iter().filter(|row| row.program.lab == lab);
            Series::new(Kind::Apart, format!("lab {lab}"), rows.filter_map(of).collect())
        });
        let streaming = self.programs.iter().max_by_key(|row| row.n).map(|row| row.streaming);
        let streams = bandwidth(streaming.unwrap_or(f64::NAN));
        let ends = self.programs.iter().filter_map(of).map(|(x, _)| x);
        let (low, high) =
            ends.fold((peak / streams, peak / streams), |(low, high), x| (low.min(x), high.max(x)));
        let roof = vec![(low, low * streams), (peak / streams, peak), (high, peak)];
        let x = Axis::log(format!("{what} per byte"));
        Chart::new(title, x, Axis::log(format!("{what} per ns")))
            .with_all(series)
            .with(Series::new(Kind::Model, "the roof: one core, measured", roof))
    }
}

fn table(rows: &[Row]) -> Table {
    let percent = |part: f64| format!("{:.0} %", 100.0 * part);
    let shared = |row: &Row, of: fn(&Shared) -> Option<f64>| {
        row.all_cores.as_ref().and_then(of).map(percent)
    };
    Columns::of("ns per particle and step", |row: &Row| row.program.to_string())
        .text("n", |row| row.n.to_string())
        .number("time", |row| Some(row.time))
        .number("instructions", |row| Some(row.bounds.instructions))
        .number("branches", |row| Some(row.bounds.branches))
        .number("bandwidth", |row| Some(row.bounds.bandwidth))
        .number("latency", |row| Some(row.bounds.latency))
        .number("least", |row| Some(row.least))
        .text("reached", |row| percent(row.reached))
        .text("held by", |row| row.held_by.clone())
        .perhaps("all cores: reached", move |row| shared(row, |all| Some(all.reached)))
        .perhaps("waiting", move |row| shared(row, |all| all.waiting))
        .perhaps("messages", move |row| shared(row, |all| all.messages))
        .table(rows)
}
