//! Times a submission and grades its times.
//!
//! The [`plan`] lists the runs: the submission, the solution and the best serial program take turns
//! on scenes that are new to all of them. A [`take`] is one run, timed by the grader's clock and
//! checked by its result. All measurements go into the record unchanged, and [`judge`] computes
//! grades from them. [`whole`] checks results only.

pub(crate) mod contest;
mod correctness;
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

use crate::record::{Findings, Kind};
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
    findings: &mut Findings,
    rubric: &Facts,
) -> Result<()> {
    let mut runs = plan(rubric, findings.seed, lab_kit::machine::cores());
    let start = Instant::now();
    (findings.timed, findings.runs) = (true, Vec::new());
    // The scene is random, so no program has seen it before. No letter contains its seed.
    let mut random = Random::new(RandomState::new().hash_one(()));
    for round in 0..MOST {
        one_round(sandbox, folders, &mut runs, round, scene(&mut random))?;
        findings.runs.clone_from(&runs);
        if round + 1 >= LEAST && !is_noisy(findings, rubric) || start.elapsed() > BUDGET {
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

/// Whether a lab's programs run beside the serial program.
pub(crate) fn has_serial(lab: &Facts) -> bool {
    lab.scaling.is_some() || lab.has_contest()
}

/// Whether every measure that can be graded on a machine with this many cores is graded.
pub(crate) fn is_done_on(cores: usize, findings: &Findings, rubric: &Facts) -> bool {
    // On a machine with one core, scaling is never graded.
    let cannot_scale = cores == 1;
    let measures = judge(findings, rubric);
    findings.timed
        && (findings.contest.is_some() || !rubric.has_contest())
        && measures
            .iter()
            .all(|measure| measure.counts() || measure.kind == Kind::Scaling && cannot_scale)
}

/// Returns the kinds of discs that a lab's programs simulate.
///
/// Each kind comes with the name of the lab's list of programs.
pub(crate) fn programs(lab: &Facts) -> Vec<(&'static str, &'static str)> {
    let own = if lab.discs == Discs::Hard { "hard" } else { "soft" };
    let hard = lab.programs.get("hard").map(|_| ("hard", "HARD_VARIANTS"));
    [(own, "VARIANTS")].into_iter().chain(hard).collect()
}

/// Returns the name of a file in the timed program, and its path in the kit.
fn timed(to: &str, from: &str) -> (String, String) {
    (to.to_owned(), format!("tests/timed/{from}"))
}

/// Returns the files of a lab's timed program: their names, and their paths in the kit.
pub(crate) fn sources(lab: &Facts) -> Vec<(String, String)> {
    let team = if lab.workers == Workers::Ranks { "ranks.rs" } else { "alone.rs" };
    let mut sources = vec![timed("main.rs", "main.rs"), timed("team.rs", team)];
    let scenes = programs(lab).into_iter().map(|(discs, _)| format!("{discs}.rs"));
    sources.extend(scenes.map(|scene| timed(&format!("scene/{scene}"), &scene)));
    sources
}
