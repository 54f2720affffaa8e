//! Checks whole programs: runs each program of a lab once on a new scene, without timing it.
//!
//! Even if all functions of a submission answer correctly, the whole program may be wrong: it may
//! recognise the questions, or its functions may not fit together.

use std::path::Path;

use anyhow::{Result, anyhow};

use super::correctness::difference;
use super::scene;
use super::take::{Compared, Order, Taken, Trouble, is_doubtful, take};
use crate::record::{Run, Task, Whose, number};
use crate::sandbox::Sandbox;
use crate::sandbox::faults::believed;
use lab_kit::Facts;
use oracle::Random;

/// A program and a scene for it.
struct PlannedRun {
    /// Last task that the program needs.
    task: String,
    run: Run,
    seed: u32,
}

impl PlannedRun {
    /// Runs the program on all processors.
    fn take(&self, sandbox: &Sandbox, folder: &Path) -> Result<Result<Taken, Trouble>> {
        let order = Order::of(&self.run, self.seed);
        take(sandbox, folder, &order, usize::MAX, sandbox.limits.run)
    }

    /// Runs the solution's program.
    fn take_right(&self, compared: Compared<'_>) -> Result<Taken> {
        let right = self.take(compared.sandbox, compared.solution)?;
        right.map_err(|(_, why)| anyhow!("the solution's {} fails: {why}", self.run.variant))
    }

    /// Describes what is wrong with the submission's program; `None` if it is right.
    ///
    /// # Errors
    /// If the solution's program fails.
    fn wrong(&self, compared: Compared<'_>) -> Result<Option<String>> {
        let right = self.take_right(compared)?;
        let taken = believed(
            || self.take(compared.sandbox, compared.own),
            is_doubtful,
            || self.take_right(compared).map(drop),
        )?;
        Ok(match taken {
            Ok(taken) => difference(&right.state, &taken.state, 0.0),
            Err((_, why)) => Some(why),
        })
    }
}

/// Plans the runs of whole programs on random scenes, in the order of their tasks.
///
/// Each program runs on a small scene, and each timed program also on a scene as large as the timed
/// one. The steps are enough for particles to meet and to cross borders, and too few for chaos, so
/// every particle must be right.
fn planned_runs(rubric: &Facts, seed: u64) -> Vec<PlannedRun> {
    let mut random = Random::new(seed);
    let mut runs = Vec::new();
    for variant in &rubric.variants {
        let Some(task) = &variant.task else { continue };
        let large = rubric.timed().find(|timed| timed.variant == variant.name);
        let large = large.map(|timed| [timed.n as f64, 1.1 * timed.n as f64]);
        for [low, high] in [[40.0, 900.0]].into_iter().chain(large) {
            let n = random.magnitude(low, high) as usize;
            let workers = 2 + random.below(3);
            let steps = 20 + random.below(60) as u64;
            let run = Run::planned(Whose::Own, &variant.name, n, workers, steps);
            runs.push((task.clone(), run));
        }
    }
    // The scenes are drawn after all runs. A different order would change the scenes of a seed.
    let runs = runs.into_iter();
    let mut planned: Vec<PlannedRun> =
        runs.map(|(task, run)| PlannedRun { task, run, seed: scene(&mut random) }).collect();
    planned.sort_by_key(|program| number(&program.task));
    planned
}

/// Runs a submission's programs and the solution's on scenes from a seed.
///
/// If all tasks of a program are right and the program is wrong nevertheless, its last task counts
/// as wrong. Other programs that need this task are then not run.
pub(crate) fn check(
    compared: Compared<'_>,
    rubric: &Facts,
    seed: u64,
    tasks: &mut [Task],
) -> Result<()> {
    for program_run in planned_runs(rubric, seed) {
        let last = number(&program_run.task);
        if tasks.iter().any(|task| number(&task.id) <= last && !task.passed) {
            continue;
        }
        let Some(wrong) = program_run.wrong(compared)? else { continue };
        let Run { variant, n, workers, steps, .. } = &program_run.run;
        for own in tasks.iter_mut().filter(|own| own.id == program_run.task) {
            (own.passed, own.share) = (false, 0.0);
            own.message = format!(
                "every question up to this task is answered rightly, and yet the whole program {variant} is wrong \
                 with {n} particles, {workers} workers and {steps} steps: {wrong}"
            );
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::{PlannedRun, planned_runs};
    use lab_kit::{Kit, rubric};

    #[test]
    fn scenes_are_others_each_time_and_reach_beyond_16_bits() {
        let kit = Kit::find().unwrap();
        let mut rubrics = rubric::all(&kit).unwrap();
        // An open lab prescribes no program.
        rubrics.retain(|_, rubric| !rubric.variants.is_empty());
        for (lab, rubric) in rubrics {
            let mut sizes = BTreeSet::new();
            for seed in 0..20 {
                let runs = planned_runs(&rubric, seed);
                sizes.extend(runs.iter().map(|PlannedRun { run, .. }| (run.n, run.steps)));
            }
            assert!(sizes.len() > 15, "lab {lab}: {sizes:?}");
            let large = rubric.timed().next().map_or(0, |timed| timed.n);
            assert!(sizes.iter().any(|(n, _)| *n >= large), "lab {lab}: {sizes:?}");
        }
    }
}
