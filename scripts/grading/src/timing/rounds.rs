//! A round: runs every program once, in turn, and compares the results.

use std::path::Path;
use std::time::Duration;

use anyhow::{Result, ensure};

use super::correctness::{STRAY, difference, is_another};
use super::plan::SERIAL;
use super::take::{Order, Taken, is_doubtful, take};
use crate::record::{Outcome, Run, Whose};
use crate::sandbox::Sandbox;
use crate::sandbox::faults::believed;
use lab_measure::experiment::turns;

/// Constant part of the time limit of a run.
const ALLOWANCE: Duration = Duration::from_secs(8);
/// Multiple of the solution's time that is added to the constant part of the time limit.
const TIMES: f64 = 10.0;

/// Result of a trusted program on a scene.
struct Right {
    run: Run,
    taken: Taken,
}

/// Runs every program once, in the order of the list or in reverse, and compares the states.
pub(crate) fn one_round(
    sandbox: &Sandbox,
    (own, solution): (&Path, &Path),
    runs: &mut [Run],
    round: usize,
    seed: u32,
) -> Result<()> {
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
        // The serial program is in the solution's folder.
        let folder = if run.whose == Whose::Own { own } else { solution };
        let once = || take(sandbox, folder, &Order::of(run, seed), run.workers, allowed);
        let taken = match believed(once, is_doubtful, || sandbox.works())? {
            Ok(taken) => taken,
            Err((outcome, why)) => {
                ensure!(run.whose == Whose::Own, "the solution cannot be timed: {why}");
                if outcome == Outcome::TooSlow {
                    run.seconds.push(allowed.as_secs_f64());
                }
                (run.outcome, run.message) = (outcome, why);
                continue;
            }
        };
        if let Some(message) = wrong(&right, run, &taken) {
            ensure!(run.whose == Whose::Own, "the solution disagrees: {message}");
            (run.outcome, run.message) = (Outcome::Wrong, message);
            continue;
        }
        run.seconds.push(taken.seconds);
        run.processors = run.processors.zip(taken.processors).map(|(sum, more)| sum + more);
        if run.whose != Whose::Own && run.steps > 0 {
            right.push(Right { run: run.clone(), taken });
        }
    }
    Ok(())
}

/// Describes what is wrong with a result; `None` if it is right.
///
/// The result is compared with those of the trusted programs.
fn wrong(right: &[Right], run: &Run, taken: &Taken) -> Option<String> {
    let first = right.first().filter(|_| run.steps > 0)?;
    let state = |is: &dyn Fn(&Run) -> bool| {
        right.iter().find(|right| is(&right.run)).map(|right| &right.taken.state)
    };
    let serial = state(&|other| other.whose == Whose::Serial);
    let solution = state(&|other| other.whose == Whose::Solution && other.variant == run.variant);
    let another = serial.zip(solution).is_some_and(|(serial, solution)| {
        run.whose == Whose::Own && is_another(&taken.state, serial, solution)
    });
    difference(&first.taken.state, &taken.state, STRAY).or_else(|| {
        another.then(|| {
            format!(
                "it has the last digits of lab 2's {SERIAL}, and {} sums in another order",
                run.variant
            )
        })
    })
}

/// Whether the program was already too slow on a smaller scene.
fn gave_up_before(runs: &[Run], run: &Run) -> bool {
    let program = |run: &Run| (run.whose, run.workers);
    runs.iter().any(|other| {
        other.outcome == Outcome::TooSlow
            && program(other) == program(run)
            && other.variant == run.variant
            && other.n < run.n
    })
}
