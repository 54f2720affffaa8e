//! Times a submission and grades its times.
//!
//! The [`plan`] lists the runs: the submission, the solution and the best serial program take turns
//! on scenes that are new to all of them. A [`take`] is one run, timed by the grader's clock and
//! checked by its result. All measurements go into the record unchanged, and [`judge`] computes
//! grades from them. [`whole_program`] checks results only.

pub(crate) mod contest;
mod correctness;
mod judge;
mod plan;
mod processors;
mod take;
pub(crate) mod whole_program;

use std::hash::{BuildHasher, RandomState};
use std::time::{Duration, Instant};

use anyhow::{Result, ensure};

use crate::record::{Findings, Kind, Outcome, Run, Whose};
use lab_kit::Facts;
use lab_measure::experiment::turns;
use oracle::Random;

use correctness::{STRAY, difference, is_another};
use judge::is_noisy;
pub(crate) use judge::{judge, seconds_of};
use plan::{SERIAL, plan};
pub(crate) use take::{Compared, PROGRAM};
use take::{Order, Taken};

/// Smallest number of rounds.
const LEAST: usize = 5;
/// Largest number of rounds.
const MOST: usize = 15;

/// Time after which no further round begins.
const BUDGET: Duration = Duration::from_secs(90);

/// Constant part of the time limit of a run.
const ALLOWANCE: Duration = Duration::from_secs(8);
/// Multiple of the solution's time that is added to the constant part of the time limit.
const TIMES: f64 = 10.0;

/// Times a submission and writes the runs into its record.
///
/// Nothing else should run on the machine.
///
/// # Errors
/// If the solution fails, or the programs cannot be started.
pub(crate) fn time(compared: Compared<'_>, findings: &mut Findings, rubric: &Facts) -> Result<()> {
    let mut runs = plan(rubric, findings.seed, lab_kit::machine::cores());
    let start = Instant::now();
    (findings.timed, findings.runs) = (true, Vec::new());
    // The scene is random, so no program has seen it before. No letter contains its seed.
    let mut random = Random::new(RandomState::new().hash_one(()));
    for round in 0..MOST {
        one_round(compared, &mut runs, round, scene(&mut random))?;
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

/// Result of a trusted program on a scene.
struct Right {
    run: Run,
    taken: Taken,
}

/// Runs every program once, in the order of the list or in reverse, and compares the states.
fn one_round(compared: Compared<'_>, runs: &mut [Run], round: usize, seed: u32) -> Result<()> {
    // Trusted programs come first: their results are right, and their times limit the other runs.
    let mut order = turns(runs.len(), round);
    order.sort_by_key(|at| (runs[*at].n, runs[*at].whose == Whose::Own));
    let mut right: Vec<Right> = Vec::new();
    for at in order {
        if runs[at].outcome != Outcome::Timed || gave_up_before(runs, &runs[at]) {
            continue;
        }
        let run = &mut runs[at];
        right.retain(|right| right.run.n == run.n);
        let allowed = right.first().map_or(ALLOWANCE * 8, |right| {
            ALLOWANCE + Duration::from_secs_f64(TIMES * right.taken.seconds)
        });
        let is_own = run.whose == Whose::Own;
        let taken = match compared.take(is_own, &Order::of(run, seed), run.workers, allowed)? {
            Ok(taken) => taken,
            Err((outcome, why)) => {
                ensure!(is_own, "the solution cannot be timed: {why}");
                if outcome == Outcome::TooSlow {
                    run.seconds.push(allowed.as_secs_f64());
                }
                (run.outcome, run.message) = (outcome, why);
                continue;
            }
        };
        if let Some(message) = wrong(&right, run, &taken) {
            ensure!(is_own, "the solution disagrees: {message}");
            (run.outcome, run.message) = (Outcome::Wrong, message);
            continue;
        }
        run.seconds.push(taken.seconds);
        run.processors = run.processors.zip(taken.processors).map(|(sum, more)| sum + more);
        if !is_own && run.steps > 0 {
            right.push(Right { run: run.clone(), taken });
        }
    }
    Ok(())
}

/// Describes what is wrong with a result; `None` if it is right.
///
/// The result is compared with the results of the trusted programs.
fn wrong(right: &[Right], run: &Run, taken: &Taken) -> Option<String> {
    let first = right.first().filter(|_| run.steps > 0)?;
    let difference = difference(&first.taken.state, &taken.state, STRAY);
    if difference.is_some() || run.whose != Whose::Own {
        return difference;
    }
    let serial = right.iter().find(|it| it.run.whose == Whose::Serial)?;
    let mut others = right.iter().filter(|it| it.run.whose == Whose::Solution);
    let solution = others.find(|it| it.run.variant == run.variant)?;
    is_another(&taken.state, &serial.taken.state, &solution.taken.state).then(|| {
        format!(
            "it has the last digits of lab 2's {SERIAL}, and {} sums in another order",
            run.variant
        )
    })
}

/// Whether the program was already too slow on a smaller scene.
fn gave_up_before(runs: &[Run], run: &Run) -> bool {
    runs.iter().any(|other| {
        other.outcome == Outcome::TooSlow
            && (other.whose, other.workers) == (run.whose, run.workers)
            && other.variant == run.variant
            && other.n < run.n
    })
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
