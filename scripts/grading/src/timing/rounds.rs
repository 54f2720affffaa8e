//! A round: every program once, in turn, and its result compared.

use std::time::Duration;

use anyhow::{Result, ensure};

use super::Programs;
use super::check::{difference, too_many_processors};
use super::plan::Job;
use super::take::{Order, Trouble, take};
use crate::record::{Outcome, Run, Whose};
use crate::sandbox::{Sandbox, is_launcher};

/// A run may take so long, and so many times the solution's time on top of it.
const ALLOWANCE: Duration = Duration::from_secs(8);
const TIMES: f64 = 10.0;

/// Every job once, forwards or backwards, and the states compared.
pub(crate) fn one_round(
    sandbox: &Sandbox,
    programs: &Programs<'_>,
    jobs: &[Job],
    runs: &mut [Run],
    round: usize,
    seed: u32,
) -> Result<()> {
    // The trusted programs come first: they say what is right and how long a run may take.
    let mut order: Vec<usize> = (0..jobs.len()).collect();
    if round % 2 == 1 {
        order.reverse();
    }
    order.sort_by_key(|at| (jobs[*at].n, jobs[*at].whose == Whose::Own));
    let mut right: Option<(usize, Vec<f64>, f64)> = None;
    for at in order {
        let (job, run) = (&jobs[at], &mut runs[at]);
        if run.outcome != Outcome::Timed || gave_up_before(jobs, runs, at) {
            continue;
        }
        let run = &mut runs[at];
        let folder = if job.whose == Whose::Own { programs.own } else { programs.solution };
        let allowed = match &right {
            Some((n, _, seconds)) if *n == job.n => {
                ALLOWANCE + Duration::from_secs_f64(TIMES * seconds)
            }
            _ => ALLOWANCE * 8,
        };
        let asked = Order { job, seed, count: false };
        let mut result = take(sandbox, folder, &asked, allowed)?;
        if matches!(&result, Err(Trouble::Broken(why)) if is_launcher(why)) {
            std::thread::sleep(ALLOWANCE / 4);
            result = take(sandbox, folder, &asked, allowed)?;
        }
        let taken = match result {
            Ok(taken) => taken,
            Err(trouble) => {
                ensure!(job.whose == Whose::Own, "the solution cannot be timed: {trouble}");
                match trouble {
                    Trouble::TooSlow(limit) => {
                        run.outcome = Outcome::TooSlow;
                        run.seconds.push(limit.as_secs_f64());
                    }
                    Trouble::Broken(_) => run.outcome = Outcome::Wrong,
                }
                run.message = trouble.to_string();
                continue;
            }
        };
        match &right {
            Some((n, state, _)) if *n == job.n && job.steps > 0 => {
                if let Some(message) = difference(state, &taken.state) {
                    ensure!(job.whose == Whose::Own, "the solution disagrees: {message}");
                    (run.outcome, run.message) = (Outcome::Wrong, message);
                    continue;
                }
            }
            _ if job.steps > 0 => right = Some((job.n, taken.state, taken.seconds)),
            _ => {}
        }
        run.seconds.push(taken.seconds);
        run.processors = match (run.processors, taken.processors) {
            (Some(sum), Some(more)) => Some(sum + more),
            _ => None,
        };
        if let Some(message) = too_many_processors(run) {
            (run.outcome, run.message) = (Outcome::Wrong, message);
        }
    }
    Ok(())
}

/// Whether the program was too slow on a smaller scene already.
fn gave_up_before(jobs: &[Job], runs: &[Run], at: usize) -> bool {
    let job = &jobs[at];
    jobs.iter().zip(runs).any(|(other, run)| {
        run.outcome == Outcome::TooSlow
            && (other.whose, &other.variant, other.workers)
                == (job.whose, &job.variant, job.workers)
            && other.n < job.n
    })
}

/// What the programs themselves count, in short runs that nobody times.
pub(crate) fn count(
    sandbox: &Sandbox,
    programs: &Programs<'_>,
    jobs: &[Job],
    runs: &mut [Run],
    seed: u32,
) -> Result<()> {
    for (job, run) in jobs.iter().zip(runs) {
        if run.outcome != Outcome::Timed || job.steps == 0 || job.whose == Whose::Serial {
            continue;
        }
        let folder = if job.whose == Whose::Own { programs.own } else { programs.solution };
        let job = Job { steps: job.steps.min(10), ..job.clone() };
        // A program that cannot count has nothing to say, and loses nothing.
        if let Ok(taken) =
            take(sandbox, folder, &Order { job: &job, seed, count: true }, ALLOWANCE)?
        {
            run.counted = taken.counted;
        }
    }
    Ok(())
}
