//! Times a submission and grades its times.
//!
//! The [`plan`] lists the runs: the submission, the solution and the best serial program take turns
//! on scenes that are new to all of them. A [`take`] is one run, timed by the grader's clock and
//! checked by its result. All measurements go into the record unchanged, and [`judge`] computes
//! grades from them. [`whole`] checks results only.

mod check;
mod judge;
mod plan;
mod processors;
mod rounds;
mod take;
pub(crate) mod whole_program;

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

/// Smallest number of rounds.
const LEAST: usize = 5;
/// Largest number of rounds.
const MOST: usize = 15;

/// Time after which no further round begins.
const BUDGET: Duration = Duration::from_secs(90);

/// Times a submission and writes the runs into its record.
///
/// `folders` are the folders of its programs and of the solution's. Nothing else should run on the
/// machine.
///
/// # Errors
/// If the solution fails, or the programs cannot be started.
pub(crate) fn time(
    sandbox: &Sandbox,
    folders: (&Path, &Path),
    record: &mut Record,
    rubric: &Facts,
) -> Result<()> {
    let mut runs = plan(rubric, record.seed, lab_kit::machine::cores());
    let start = Instant::now();
    (record.timed, record.runs) = (true, Vec::new());
    // The scene is random: no program has seen it before, and no letter names its seed.
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

/// Draws the seed of a scene.
fn scene(random: &mut Random) -> u32 {
    // Seed 0 has a special meaning in the official program.
    random.bits() as u32 | 1
}

/// Whether every measure is graded that can be graded on a machine with this many cores.
pub(crate) fn is_done_on(cores: usize, record: &Record, rubric: &Facts) -> bool {
    // On a machine with one core, scaling is never graded.
    let cannot_be = |measure: &Measure| measure.kind == Kind::Scaling && cores == 1;
    let is_judged = |measure: &Measure| measure.counts() || cannot_be(measure);
    record.timed && judge(record, rubric).iter().all(is_judged)
}

/// Returns the kinds of discs that a lab's programs simulate.
///
/// Each kind comes with the name of the lab's list of programs.
pub(crate) fn programs(lab: &Facts) -> Vec<(&'static str, &'static str)> {
    let own = if lab.discs == Discs::Hard { "hard" } else { "soft" };
    let hard = lab.programs.get("hard").map(|_| ("hard", "HARD_VARIANTS"));
    [(own, "VARIANTS")].into_iter().chain(hard).collect()
}

/// Returns the files of a lab's timed program: their names, and their paths in the kit.
pub(crate) fn sources(lab: &Facts) -> Vec<(String, String)> {
    let timed = |to: &str, from: &str| (to.to_owned(), format!("tests/timed/{from}"));
    let team = if lab.workers == Workers::Ranks { "ranks.rs" } else { "alone.rs" };
    let mut sources = vec![timed("main.rs", "main.rs"), timed("team.rs", team)];
    let scenes = programs(lab).into_iter().map(|(discs, _)| format!("{discs}.rs"));
    sources.extend(scenes.map(|scene| timed(&format!("scene/{scene}"), &scene)));
    sources
}
