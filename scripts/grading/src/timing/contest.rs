//! Runs an entry of the contest in the sandbox, and times it by the grader's clock.
//!
//! `cargo lab contest` trusts the times that a program prints. A submission could print any time, so
//! here the grader takes the time, and a result counts only with the error that it has.

use std::hash::{BuildHasher, RandomState};
use std::time::Duration;

use anyhow::Result;
use common::soft::Particle;

use super::take::{Compared, Order};
use crate::record::Findings;
use lab_kit::machine::cores;
use lab_kit::program::Program;
use lab_kit::table::three_digits;
use lab_measure::commands::contest::{Contest, Drawn, Entry, REFERENCE, unranked};
use lab_measure::job::{Job, RunOutput};
use oracle::Random;

/// Number of rounds, each with new scenes.
const ROUNDS: u32 = 3;

/// Greatest time of a run.
const LIMIT: Duration = Duration::from_secs(60);

/// Name of the entry among the submission's variants.
const ENTRY: &str = "entry";

/// The contest of a class: all its entries run on the same scenes.
pub(crate) struct ClassContest {
    contest: Contest,
    scenes: Vec<Drawn>,
}

impl ClassContest {
    /// Draws new scenes and computes their exact ends.
    pub(crate) fn draw() -> Result<Self> {
        let mut random = Random::new(RandomState::new().hash_one(()));
        let reference: Program = REFERENCE.parse().map_err(anyhow::Error::msg)?;
        let seed = 1 + random.below(1 << 30) as u32;
        let contest = Contest { reference, threads: cores(), shrink: 1, seed };
        Ok(Self { scenes: contest.scenes(ROUNDS)?, contest })
    }

    /// Measures an entry and writes it into its record.
    ///
    /// # Errors
    /// If the reference fails, or the programs cannot be started.
    pub(crate) fn enter(&self, compared: Compared<'_>, findings: &mut Findings) -> Result<()> {
        let program = format!("lab{}:{ENTRY}", findings.lab).parse().map_err(anyhow::Error::msg)?;
        let mut entry = Entry::new(program);
        let entries = std::slice::from_mut(&mut entry);
        self.contest.measure(&|drawn, job| run(compared, drawn, job), &self.scenes, entries)?;
        (findings.timed, findings.contest) = (true, Some(entry));
        Ok(())
    }
}

/// Runs a job in the sandbox. The reference, which is a solution's, is the serial program.
fn run(compared: Compared<'_>, drawn: &Drawn, job: &Job) -> Result<Result<RunOutput, String>> {
    let order = Order {
        serial: job.program.solution,
        variant: job.program.variant.as_deref().unwrap_or_default(),
        workers: job.workers,
        n: drawn.scene.len(),
        seed: drawn.seed,
        steps: job.steps,
        kind: drawn.kind,
    };
    let taken = match compared.take(!job.program.solution, &order, usize::MAX, LIMIT)? {
        Ok(taken) => taken,
        Err((_, why)) => return Ok(Err(why)),
    };
    let back = taken.state.len() / 4;
    if back != order.n {
        return Ok(Err(format!("{back} particles came back, not {}", order.n)));
    }
    let mut particles = Vec::new();
    for (id, values) in (0..).zip(taken.state.chunks_exact(4)) {
        let [x, y, vx, vy] = values.try_into().expect("four numbers");
        particles.push(Particle { x, y, vx, vy, id });
    }
    Ok(Ok(RunOutput {
        seconds: taken.seconds,
        resident: taken.memory,
        frames: vec![particles],
        ..RunOutput::default()
    }))
}

/// Describes an entry's place in the plane, and why it is not ranked.
pub(crate) fn summary(entry: &Entry) -> String {
    let mut parts = Vec::new();
    if let Some((time, error)) = entry.time.zip(entry.error) {
        let [time, error] = [time, error].map(|span| three_digits(span.median));
        parts.push(format!("time {time} × {REFERENCE}, error {error} × official step"));
    }
    parts.extend(unranked(entry).map(|why| format!("not ranked: {why}")));
    parts.join("; ")
}
