//! Runs that a measure needs, and their times in seconds.

use super::Without;
use crate::record::{Findings, Outcome, Run, Verdict, Whose};
use lab_kit::facts::Timed;
use lab_measure::clock::{Span, Times};

/// Largest ratio of the median to the shortest take of a quiet program. A smaller ratio does not
/// change a grade.
const QUIET: f64 = 1.06;

/// Greatest possible ratio of the speeds of two programs on the same number of processors. The
/// kit's fastest program is 25 times as fast as the slowest program that is timed.
const IMPOSSIBLE: f64 = 30.0;

/// A program that has a free processor and does not wait computes for at least this share of its
/// time.
const MOSTLY: f64 = 0.7;
/// Length of a pause in a take, in seconds, above which the pause counts as waiting. Shorter pauses
/// are errors of the clock.
const LONG: f64 = 0.01;

/// All runs of a record, and a measure that is computed from them.
pub(crate) struct Runs<'r> {
    pub(crate) all: &'r [Run],
    pub(crate) timed: &'r Timed,
}

impl<'r> Runs<'r> {
    /// Returns the runs of one program that the measure needs.
    pub(crate) fn of(&self, whose: Whose) -> impl Iterator<Item = &'r Run> {
        let variant = &self.timed.variant;
        self.all.iter().filter(move |run| {
            run.whose == whose
                && run.steps > 0
                && (run.variant == *variant || whose == Whose::Serial)
        })
    }

    pub(crate) fn not_timed(&self, n: usize) -> Without {
        let why = format!("{} was not timed at n = {n}: grade it again", self.timed.variant);
        (Verdict::NotTimed, why)
    }

    /// Finds a run whose result was not wrong.
    pub(crate) fn find(&self, whose: Whose, n: usize, workers: usize) -> Result<&'r Run, Without> {
        let mut of_n = self.of(whose).filter(|run| run.n == n);
        let run = of_n.find(|run| run.workers == workers).ok_or_else(|| self.not_timed(n))?;
        if run.outcome == Outcome::Wrong {
            let why = format!("its result is wrong, so its time is worth nothing: {}", run.message);
            return Err((Verdict::Wrong, why));
        }
        if whose == Whose::Own { self.possible(run) } else { Ok(run) }
    }

    /// Returns `run`, a run of the submission, or an error if its time is impossibly short.
    fn possible(&self, run: &'r Run) -> Result<&'r Run, Without> {
        let trusted = self.all.iter().filter(|other| other.whose != Whose::Own);
        for trusted in trusted.filter(|other| (other.n, other.steps) == (run.n, run.steps)) {
            let shortest = span(run).map_or(f64::INFINITY, |span| span.min);
            // `net` subtracts the time for making the scene. So a correct program needs at least
            // `work / IMPOSSIBLE` seconds of processor time.
            let work = net(self.all, trusted)?.min * trusted.workers as f64;
            if shortest * run.workers as f64 * IMPOSSIBLE < work {
                let why = format!(
                    "it took {shortest:.1e} s for {} particles, which is impossible: it does not \
                     do all of the work while it is timed",
                    run.n
                );
                return Err((Verdict::Wrong, why));
            }
        }
        Ok(run)
    }

    /// Returns the time, in seconds, of the run with this program, size and number of workers.
    pub(crate) fn time(&self, whose: Whose, n: usize, workers: usize) -> Result<Span, Without> {
        self.seconds(self.find(whose, n, workers)?)
    }

    /// Returns the time of a run, in seconds; infinite if the run was too slow.
    pub(crate) fn seconds(&self, run: &Run) -> Result<Span, Without> {
        match run.outcome {
            Outcome::TooSlow => Ok(Span { min: f64::INFINITY, median: f64::INFINITY }),
            _ => net(self.all, run),
        }
    }

    /// Whether the solution's takes were quiet in every run that the measure needs.
    pub(crate) fn is_quiet(&self) -> bool {
        self.of(Whose::Own).all(|own| {
            let beside = self.find(Whose::Solution, own.n, own.workers).ok().and_then(span);
            beside.is_some_and(|span| span.median / span.min < QUIET)
        })
    }
}

/// Returns the average number of busy processors of a run; infinite if it is unknown.
pub(crate) fn busy(run: &Run) -> f64 {
    let wall: f64 = run.seconds.iter().sum();
    run.processors.filter(|busy| *busy > 0.0).map_or(f64::INFINITY, |busy| busy / wall)
}

/// Returns the share of the time in which a run of one worker computed; `None` if it did not wait.
pub(crate) fn waited(run: &Run) -> Option<f64> {
    let takes = run.seconds.len() as f64;
    let wall = run.seconds.iter().sum::<f64>();
    let share = busy(run);
    let waits = share < MOSTLY && wall * (1.0 - share) > LONG * takes;
    (run.outcome == Outcome::Timed && waits).then_some(share)
}

/// Returns the time of a run's shortest take, in seconds; `None` if the run is not valid.
///
/// The time for making the scene and sending the result is subtracted.
pub(crate) fn seconds_of(findings: &Findings, run: &Run) -> Option<f64> {
    let timed = run.outcome == Outcome::Timed;
    timed.then(|| net(&findings.runs, run).ok())?.map(|span| span.min)
}

/// Returns the measured time of a run, in seconds; `None` if the run has no take.
fn span(run: &Run) -> Option<Span> {
    Times::of(run.seconds.clone()).map(|times| times.span(1.0))
}

/// Returns the time of a run, in seconds, without making the scene and sending the result.
fn net(runs: &[Run], run: &Run) -> Result<Span, Without> {
    let all = taken(run)?;
    let Some(idle) = idle(runs, run) else { return Ok(all) };
    let idle = taken(idle)?;
    // A difference below a microsecond becomes a microsecond.
    Ok(Span::both(|way| (way(&all) - way(&idle)).max(1e-6)))
}

/// Returns the measured seconds of a run, or the verdict that it was not timed.
fn taken(run: &Run) -> Result<Span, Without> {
    span(run).ok_or_else(|| (Verdict::NotTimed, "no take was finished: grade it again".into()))
}

/// Finds a trusted run without steps on the same number of particles. A run of the same program and
/// the same number of workers is preferred.
fn idle<'r>(runs: &'r [Run], run: &Run) -> Option<&'r Run> {
    let trusted = runs.iter().filter(|other| other.whose != Whose::Own);
    let mut all = trusted.filter(|other| other.steps == 0 && other.n == run.n);
    let first = all.clone().next();
    all.find(|r| (&r.variant, r.workers) == (&run.variant, run.workers)).or(first)
}
