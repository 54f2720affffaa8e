//! Times of a submission, and what they are worth.
//!
//! The [`plan`] says what runs: the submission, the solution and the best serial program take
//! turns on scenes that nobody knew before. A [`take`] is one run, on our clock and judged by its
//! result. All of it goes into the record as it is, and [`judge`] makes grades of that. [`whole`] looks at results alone.

mod check;
mod judge;
mod plan;
mod processors;
mod rounds;
mod take;
pub(crate) mod whole;

use std::hash::{BuildHasher, RandomState};
use std::path::Path;
use std::time::{Duration, Instant};

use anyhow::Result;

use crate::record::{Kind, Measure, Record};
use crate::sandbox::Sandbox;
use lab_kit::{Discs, Facts, Workers};
use oracle::Random;
use plan::plan;
use rounds::one_round;

use judge::is_noisy;
pub(crate) use judge::{judge, seconds_of};
pub(crate) use take::PROGRAM;

/// Rounds at least, and at most.
const LEAST: usize = 5;
const MOST: usize = 15;

/// No further round begins after this time.
const BUDGET: Duration = Duration::from_secs(90);

/// Times a submission and writes into its record what came out. Its programs and the solution's lie in a folder
/// each. Nothing else should run.
///
/// # Errors
/// The solution fails, or the programs cannot be started.
pub(crate) fn time(
    sandbox: &Sandbox,
    folders: (&Path, &Path),
    record: &mut Record,
    rubric: &Facts,
) -> Result<()> {
    let mut runs = plan(rubric, record.seed, lab_kit::machine::cores());
    let start = Instant::now();
    (record.timed, record.runs) = (true, Vec::new());
    // No program that was asked before has seen it, and no letter names it.
    let mut random = Random::new(RandomState::new().hash_one(()));
    for round in 0..MOST {
        one_round(sandbox, folders, &mut runs, round, scene(&mut random))?;
        record.runs.clone_from(&runs);
        if round + 1 >= LEAST && !is_noisy(record, rubric) || start.elapsed() > BUDGET {
            break;
        }
    }
    Ok(())
}

/// A scene's number.
fn scene(random: &mut Random) -> u32 {
    // Seed 0 means another thing to the official program.
    random.bits() as u32 | 1
}

/// Whether nothing is left to be timed: everything is graded that can be on a machine with so many cores.
pub(crate) fn is_done_on(cores: usize, record: &Record, rubric: &Facts) -> bool {
    // With one core scaling is never graded.
    let cannot_be = |measure: &Measure| measure.kind == Kind::Scaling && cores == 1;
    let is_judged = |measure: &Measure| measure.counts() || cannot_be(measure);
    record.timed && judge(record, rubric).iter().all(is_judged)
}

/// What a lab's programs simulate, each with the lab's name for their list.
pub(crate) fn programs(lab: &Facts) -> Vec<(&'static str, &'static str)> {
    let own = if lab.discs == Discs::Hard { "hard" } else { "soft" };
    let hard = lab.programs.get("hard").map(|_| ("hard", "HARD_VARIANTS"));
    [(own, "VARIANTS")].into_iter().chain(hard).collect()
}

/// The files of a lab's timed program: their names, and where they are in the kit.
pub(crate) fn sources(lab: &Facts) -> Vec<(String, String)> {
    let timed = |to: &str, from: &str| (to.to_owned(), format!("tests/timed/{from}"));
    let team = if lab.workers == Workers::Ranks { "ranks.rs" } else { "alone.rs" };
    let mut sources = vec![timed("main.rs", "main.rs"), timed("team.rs", team)];
    let scenes = programs(lab).into_iter().map(|(discs, _)| format!("{discs}.rs"));
    sources.extend(scenes.map(|scene| timed(&format!("scene/{scene}"), &scene)));
    sources
}
