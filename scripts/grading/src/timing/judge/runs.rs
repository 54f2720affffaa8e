//! The runs that a measure is made of, and their seconds.

use super::{Of, Without};
use crate::record::{Outcome, Record, Run, Whose};
use crate::timing::plan::STEPS;
use lab_kit::rubric::Timed;
use lab_measure::clock::Times;

pub(crate) fn is(run: &Run, whose: Whose, timed: &Timed, steps: u64) -> bool {
    let same = run.variant == timed.variant || run.whose == Whose::Serial;
    run.whose == whose && run.steps == steps && same
}

pub(crate) fn not_timed(timed: &Timed, n: usize) -> Without {
    Without::NotTimed(format!("{} was not timed at n = {n}: grade it again", timed.variant))
}

pub(crate) fn find<'r>(
    runs: &'r [Run],
    whose: Whose,
    timed: &Timed,
    (n, workers): (usize, usize),
) -> Result<&'r Run, Without> {
    let found =
        runs.iter().find(|r| is(r, whose, timed, STEPS) && r.n == n && r.workers == workers);
    found.ok_or_else(|| not_timed(timed, n))
}

/// Medians and shortest takes of a quiet program are less than this apart: not enough for another grade.
const QUIET: f64 = 1.06;

/// No program does so many times the work of a trusted one on as many processors. The fastest of the kit
/// is 25 times as fast as the slowest that is timed.
const IMPOSSIBLE: f64 = 30.0;

/// A run of the submission, if it was not wrong.
pub(crate) fn own<'r>(
    runs: &'r [Run],
    timed: &Timed,
    n: usize,
    workers: usize,
) -> Result<&'r Run, Without> {
    let run = judged(find(runs, Whose::Own, timed, (n, workers))?)?;
    let trusted = runs.iter().filter(|r| r.whose != Whose::Own && (r.n, r.steps) == (n, STEPS));
    for trusted in trusted {
        let whole = Times::of(run.seconds.clone()).map_or(f64::INFINITY, |times| times.min());
        // Without what it takes to make the scene: that much is certain.
        let work = net(runs, trusted, Times::min)? * trusted.workers as f64;
        if whole * workers as f64 * IMPOSSIBLE < work {
            let why = format!(
                "it took {whole:.1e} s for {n} particles, which is impossible: what its time is taken \
                 from is not this work"
            );
            return Err(Without::Wrong(why));
        }
    }
    Ok(run)
}

pub(crate) fn judged(run: &Run) -> Result<&Run, Without> {
    if run.outcome == Outcome::Wrong {
        let why = format!("its result is wrong, so its time is worth nothing: {}", run.message);
        return Err(Without::Wrong(why));
    }
    Ok(run)
}

pub(crate) fn solution<'r>(
    runs: &'r [Run],
    timed: &Timed,
    n: usize,
    workers: usize,
) -> Result<&'r Run, Without> {
    find(runs, Whose::Solution, timed, (n, workers))
}

pub(crate) fn serial<'r>(runs: &'r [Run], timed: &Timed, n: usize) -> Result<&'r Run, Without> {
    find(runs, Whose::Serial, timed, (n, 1))
}

pub(crate) fn longest(run: &Run) -> f64 {
    run.seconds.iter().copied().fold(0.0, f64::max)
}

/// How many processors a run kept busy; all of them where the system does not say.
pub(crate) fn busy(run: &Run) -> f64 {
    let wall: f64 = run.seconds.iter().sum();
    run.processors.filter(|busy| *busy > 0.0).map_or(f64::INFINITY, |busy| busy / wall)
}

/// Whether the solution's takes beside the submission's were quiet, wherever a measure looks.
pub(crate) fn is_quiet(runs: &[Run], timed: &Timed) -> bool {
    let own = runs.iter().filter(|run| is(run, Whose::Own, timed, STEPS));
    let beside = own.map(|own| find(runs, Whose::Solution, timed, (own.n, own.workers)));
    let mut spread = beside.map(|run| {
        let times = run.ok().and_then(|run| Times::of(run.seconds.clone()));
        times.map_or(f64::INFINITY, |times| times.median() / times.min())
    });
    spread.all(|spread| spread < QUIET)
}

/// Seconds of a run's shortest take, without start and result; none without a take.
pub(crate) fn seconds_of(record: &Record, run: &Run) -> Option<f64> {
    if run.outcome == Outcome::Timed { net(&record.runs, run, Times::min).ok() } else { None }
}

/// Seconds of a run; forever if it was too slow.
pub(crate) fn seconds(runs: &[Run], run: &Run, way: Of) -> Result<f64, Without> {
    if run.outcome == Outcome::TooSlow { Ok(f64::INFINITY) } else { net(runs, run, way) }
}

/// Seconds of a run without those that it takes to make such a scene and to send the result.
pub(crate) fn net(runs: &[Run], run: &Run, way: Of) -> Result<f64, Without> {
    let times = |run: &Run| {
        let none = || Without::NotTimed("no take was finished: grade it again".into());
        Times::of(run.seconds.clone()).map(|times| way(&times)).ok_or_else(none)
    };
    let idle = || runs.iter().filter(|r| r.whose != Whose::Own && r.steps == 0 && r.n == run.n);
    let alike = |r: &&Run| (&r.variant, r.workers) == (&run.variant, run.workers);
    let idle = idle().find(alike).or_else(|| idle().next()).map(times);
    let idle = idle.transpose()?.unwrap_or(0.0);
    Ok((times(run)? - idle).max(1e-6))
}
