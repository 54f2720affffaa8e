//! A round: every program once, in turn, and its result compared.

use std::time::Duration;

use anyhow::{Result, ensure};

use super::Programs;
use super::check::{difference, is_another};
use super::plan::{Job, SERIAL};
use super::take::{Order, Taken, Trouble, take};
use crate::record::{Outcome, Run, Whose};
use crate::sandbox::{Sandbox, is_launcher};

/// A run may take so long, and so many times the solution's time on top of it.
const ALLOWANCE: Duration = Duration::from_secs(8);
const TIMES: f64 = 10.0;

/// What a trusted program made of a scene of n particles.
struct Right<'j> {
    job: &'j Job,
    taken: Taken,
}

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
    let mut right: Vec<Right<'_>> = Vec::new();
    for at in order {
        let job = &jobs[at];
        if runs[at].outcome != Outcome::Timed || gave_up_before(jobs, runs, at) {
            continue;
        }
        let run = &mut runs[at];
        right.retain(|right| right.job.n == job.n);
        let folder = if job.whose == Whose::Own { programs.own } else { programs.solution };
        let allowed = right.first().map_or(ALLOWANCE * 8, |right| {
            ALLOWANCE + Duration::from_secs_f64(TIMES * right.taken.seconds)
        });
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
        if let Some(message) = wrong(&right, job, &taken) {
            ensure!(job.whose == Whose::Own, "the solution disagrees: {message}");
            (run.outcome, run.message) = (Outcome::Wrong, message);
            continue;
        }
        run.seconds.push(taken.seconds);
        run.processors = match (run.processors, taken.processors) {
            (Some(sum), Some(more)) => Some(sum + more),
            _ => None,
        };
        if job.whose != Whose::Own && job.steps > 0 {
            right.push(Right { job, taken });
        }
    }
    Ok(())
}

/// What is wrong with a result, by those of the trusted programs.
fn wrong(right: &[Right<'_>], job: &Job, taken: &Taken) -> Option<String> {
    let first = right.first().filter(|_| job.steps > 0)?;
    let state = |is: &dyn Fn(&Job) -> bool| {
        right.iter().find(|right| is(right.job)).map(|right| &right.taken.state)
    };
    let serial = state(&|other| other.whose == Whose::Serial);
    let solution = state(&|other| other.whose == Whose::Solution && other.variant == job.variant);
    let another = serial.zip(solution).is_some_and(|(serial, solution)| {
        job.whose == Whose::Own && is_another(&taken.state, serial, solution)
    });
    difference(&first.taken.state, &taken.state).or_else(|| {
        another.then(|| {
            format!(
                "it has the last digits of lab 2's {SERIAL}, and {} sums in another order",
                job.variant
            )
        })
    })
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
