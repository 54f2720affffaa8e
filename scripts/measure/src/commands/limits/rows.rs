//! The least time and the measured time of each program, and their table.

use anyhow::Result;
use lab_kit::program::Program;
use lab_kit::table::Table;
use lab_kit::{Discs, machine};
use serde::{Deserialize, Serialize};

use super::takes::{Counted, Take};
use crate::bounds::{Bounds, Costs, bytes};
use crate::columns::Columns;
use crate::job::{Job, RunOutput};
use crate::runner::Runner;

/// Floating-point operations of the distance of two particles.
const DISTANCE: f64 = 5.0;
/// Floating-point operations of the force of a pair on one of its particles. A division or a root
/// counts as one operation.
const FORCE: f64 = 9.0;
/// Floating-point operations of the move of a particle.
const MOVE: f64 = 8.0;

#[derive(Deserialize, Serialize)]
pub(super) struct Row {
    pub(super) program: Program,
    pub(super) n: usize,
    /// Measured nanoseconds per particle and step. In contrast, `bounds` and `least` are computed
    /// from the counts.
    pub(super) time: f64,
    bounds: Bounds,
    least: f64,
    /// The least time as a share of the measured time. `held_by` names the bound that limits the
    /// program.
    reached: f64,
    held_by: String,
    /// Nanoseconds that streaming takes for one particle.
    pub(super) streaming: f64,
    pub(super) instructions: f64,
    /// Bytes that are loaded into the first-level cache, per particle and step.
    pub(super) bytes: f64,
    /// Floating-point operations per particle and step; `None` if pairs are not counted.
    pub(super) operations: Option<f64>,
    all_cores: Option<Shared>,
}

/// A run with a worker for each core.
#[derive(Deserialize, Serialize)]
pub(super) struct Shared {
    pub(super) time: f64,
    /// The time of one worker, divided by the number of workers and by the time of this run.
    reached: f64,
    /// Shares of the time, averaged over the workers; `None` if they are not counted.
    waiting: Option<f64>,
    messages: Option<f64>,
}

impl Row {
    /// Compares the shortest takes of a program with the bounds that its counts give.
    pub(super) fn new(
        run: &Counted,
        least: Take,
        costs: &Costs,
        runner: &Runner,
        steps: u64,
    ) -> Result<Self> {
        let counts = run.row.counts();
        let bounds = Bounds::new(counts, costs, least.streaming);
        let each = 1e9 / (run.n() as f64 * steps as f64);
        let time = each * least.seconds();
        let all_cores =
            least.seconds_on_all().map(|all| Shared::new(runner, run, each * all, time));
        Ok(Self {
            program: run.row.job.program.clone(),
            n: run.n(),
            time,
            bounds,
            least: bounds.least(),
            reached: bounds.least() / time,
            held_by: bounds.holding(time).into(),
            streaming: least.streaming,
            instructions: counts[0],
            bytes: bytes(counts),
            operations: operations(runner, &run.job(1, run.after + steps))?,
            all_cores: all_cores.transpose()?,
        })
    }
}

/// Returns the floating-point operations per particle and step that the formulas need for the pairs
/// that a run counts.
fn operations(runner: &Runner, job: &Job) -> Result<Option<f64>> {
    if job.program.discs != Discs::Soft {
        return Ok(None);
    }
    let output = runner.run(&Job { statistics: true, ..job.clone() })?;
    let Some(pairs) = output.statistics else { return Ok(None) };
    let listed = output.counters.get("pair tests per particle and step");
    let tests = *listed.unwrap_or(&pairs.pair_tests);
    Ok(Some(DISTANCE * tests + FORCE * pairs.neighbours + MOVE))
}

impl Shared {
    fn new(runner: &Runner, run: &Counted, time: f64, alone: f64) -> Result<Self> {
        let job = run.job(machine::cores(), run.after + run.row.job.steps);
        // Ranks report their waiting time only if they record events, but not all programs can
        // record events.
        let recorded = job.program.has_ranks().then(|| Job { events: true, ..job.clone() });
        let recorded = recorded.and_then(|job| runner.run(&job).ok());
        let output = recorded.map_or_else(|| runner.run(&job), Ok)?;
        let all = job.workers as f64;
        Ok(Self {
            time,
            reached: alone / all / time,
            waiting: counted_seconds(&output, "wait").map(|sum| sum / all / output.seconds),
            messages: counted_seconds(&output, "communicate").map(|sum| sum / all / output.seconds),
        })
    }
}

/// Adds up the counters of seconds whose names contain `what`; `None` if there are no such
/// counters.
fn counted_seconds(output: &RunOutput, what: &str) -> Option<f64> {
    let counters = output.counters.iter();
    let of = counters.filter(|(name, _)| name.contains(what) && name.contains("[s]"));
    of.map(|(_, seconds)| *seconds).reduce(|a, b| a + b)
}

pub(super) fn table(rows: &[Row]) -> Table {
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
        .perhaps("all cores: reached", |row| Some(percent(row.all_cores.as_ref()?.reached)))
        .perhaps("waiting", |row| Some(percent(row.all_cores.as_ref()?.waiting?)))
        .perhaps("messages", |row| Some(percent(row.all_cores.as_ref()?.messages?)))
        .table(rows)
}

fn percent(part: f64) -> String {
    format!("{:.0} %", 100.0 * part)
}
