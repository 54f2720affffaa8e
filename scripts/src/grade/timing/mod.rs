//! Times of a submission, and what they are worth.
//!
//! The [`plan`] says what runs: the submission, the solution and the best serial program take
//! turns on scenes that nobody knew before. A [`take`] is one run, on our clock and judged by its
//! result. All of it goes into the record as it is, and [`judge`] makes grades of that.

mod judge;
mod plan;
mod processors;
mod take;

use std::path::Path;
use std::time::{Duration, Instant};

use anyhow::{Result, ensure};

use super::probe::is_launcher;
use super::record::{Measure, Outcome, Record, Run, Verdict, Whose};
use super::rubric::Rubric;
use super::sandbox::Sandbox;
use crate::kit::Lab;
use plan::{Job, jobs};
use take::{Order, Trouble, take};

pub(crate) use judge::{judge, seconds_of};
pub(crate) use take::PROGRAM;

/// Rounds at least, and at most.
const LEAST: usize = 5;
const MOST: usize = 15;

/// No further round begins after so long.
const BUDGET: Duration = Duration::from_secs(90);

/// A run may take so long, and so many times the solution's time on top of it.
const ALLOWANCE: Duration = Duration::from_secs(8);
const TIMES: f64 = 10.0;

/// Two programs differ by rounding, and chaos makes more of it: this share of the particles may
/// differ by more than [`CLOSE`] after the steps. Whoever leaves out a step moves all of them.
const STRAY: f64 = 0.001;
const CLOSE: f64 = 1e-9;

/// The programs that take part, each in a folder of its own.
pub(crate) struct Programs<'a> {
    /// The submission's.
    pub(crate) own: &'a Path,
    /// The solution's.
    pub(crate) solution: &'a Path,
}

/// Times a submission and writes into its record what came out. Nothing else should run.
///
/// # Errors
/// The solution fails, or the programs cannot be started.
pub(crate) fn time(
    sandbox: &Sandbox,
    programs: &Programs<'_>,
    record: &mut Record,
    rubric: &Rubric,
) -> Result<()> {
    let jobs = jobs(rubric, crate::measure::rounds::cores());
    let mut runs: Vec<Run> = jobs.iter().map(Job::run).collect();
    let start = Instant::now();
    (record.timed, record.runs) = (true, Vec::new());
    for round in 0..MOST {
        let seed = seed(record.seed, round);
        one_round(sandbox, programs, &jobs, &mut runs, round, seed)?;
        record.runs.clone_from(&runs);
        let noisy = judge(record, rubric).iter().any(|m| m.verdict == Verdict::TooNoisy);
        if round + 1 >= LEAST && !noisy || start.elapsed() > BUDGET {
            break;
        }
    }
    count(sandbox, programs, &jobs, &mut runs, seed(record.seed, MOST))?;
    record.runs = runs;
    Ok(())
}

/// Every job once, forwards or backwards, and the states compared.
fn one_round(
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
fn count(
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

/// What is wrong with a state; none if it is the right one up to rounding.
fn difference(right: &[f64], given: &[f64]) -> Option<String> {
    if right.len() != given.len() {
        return Some(format!("{} particles came back, not {}", given.len() / 4, right.len() / 4));
    }
    let close = |(want, got): (&f64, &f64)| (want - got).abs() <= CLOSE * (1.0 + want.abs());
    let pairs = right.chunks(4).zip(given.chunks(4)).enumerate();
    let strays: Vec<_> =
        pairs.filter(|(_, (want, got))| !want.iter().zip(got.iter()).all(close)).collect();
    let (number, (want, got)) = strays.first()?;
    let allowed = STRAY * (right.len() / 4) as f64;
    (strays.len() as f64 > allowed.max(1.0)).then(|| {
        format!(
            "after the timed steps {} of {} particles are not where they should be; particle \
             {number} is at ({:e}, {:e}), not at ({:e}, {:e})",
            strays.len(),
            right.len() / 4,
            got[0],
            got[1],
            want[0],
            want[1]
        )
    })
}

/// A program that found its way to more processors than it was given. The system counts time in
/// hundredths of a second, for each process.
fn too_many_processors(run: &Run) -> Option<String> {
    let wall: f64 = run.seconds.iter().sum();
    let slack = 0.03 * run.seconds.len() as f64;
    let busy = run.processors?;
    (busy > 1.1 * run.workers as f64 * wall + slack).then(|| {
        format!("it kept {:.1} processors busy where it was given {}", busy / wall, run.workers)
    })
}

/// A scene's number that follows from the record's, and is another one each round.
fn seed(seed: u64, round: usize) -> u32 {
    let z = seed.wrapping_add(0x9e37_79b9_7f4a_7c15_u64.wrapping_mul(round as u64 + 1));
    let z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    // Seed 0 means another thing to the official program.
    (z >> 32) as u32 | 1
}

/// Whether nothing is left to be timed: everything that could be graded is.
pub(crate) fn is_done(record: &Record, rubric: &Rubric) -> bool {
    record.timed && judge(record, rubric).iter().all(Measure::counts)
}

/// The files of the timed program: their names, and where they are in the kit.
pub(crate) fn sources(lab: Lab) -> [(&'static str, &'static str); 2] {
    let hard = matches!(lab.number(), 7 | 8);
    let scene = if hard { "tests/timed/hard.rs" } else { "tests/timed/soft.rs" };
    [("main.rs", "tests/timed/main.rs"), ("scene.rs", scene)]
}

#[cfg(test)]
mod tests {
    use super::{difference, seed, too_many_processors};
    use crate::grade::record::{Outcome, Run, Whose};

    #[test]
    fn rounding_is_no_difference_and_a_step_left_out_is() {
        let right: Vec<f64> = (0..4000).map(|i| f64::from(i) * 1e-3).collect();
        let mut given: Vec<f64> = right.iter().map(|x| x + 1e-13).collect();
        assert_eq!(difference(&right, &given), None);
        // One particle of a thousand may have met chaos; two may not.
        given[8] += 1.0;
        assert_eq!(difference(&right, &given), None);
        given[12] = f64::NAN;
        let message = difference(&right, &given).unwrap();
        assert!(
            message.contains("2 of 1000 particles") && message.contains("particle 2"),
            "{message}"
        );
        assert!(difference(&right, &right[..8]).unwrap().contains("2 particles came back"));
    }

    #[test]
    fn nobody_takes_more_processors_than_it_was_given() {
        let mut run = Run {
            whose: Whose::Own,
            variant: String::new(),
            n: 1000,
            workers: 1,
            steps: 50,
            seconds: vec![1.0; 5],
            processors: Some(5.3),
            outcome: Outcome::Timed,
            message: String::new(),
            counted: Default::default(),
        };
        assert_eq!(too_many_processors(&run), None);
        run.processors = Some(9.0);
        assert!(too_many_processors(&run).unwrap().contains("1.8 processors"));
        run.workers = 2;
        assert_eq!(too_many_processors(&run), None);
    }

    #[test]
    fn every_round_has_a_scene_of_its_own() {
        let seeds: std::collections::BTreeSet<u32> = (0..15).map(|round| seed(7, round)).collect();
        assert_eq!(seeds.len(), 15);
        assert!(!seeds.contains(&0));
    }
}
