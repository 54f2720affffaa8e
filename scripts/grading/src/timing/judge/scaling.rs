//! Grade of scaling: how much faster a program is with more workers.

use super::runs::{Runs, busy};
use super::{Found, Without};
use crate::record::{Run, Verdict, Whose};
use lab_measure::autograder::{averages, scaling_grade, strong_efficiency, weak_efficiency};
use lab_measure::clock::Span;

/// Speedup, or number of busy processors, below which several workers count as one.
const MORE_THAN_ONE: f64 = 1.1;

/// Number of busy processors that the solution must exceed.
///
/// On a machine with other work, a program with one worker cannot be distinguished from a program
/// whose workers got no processor.
const CLEARLY_MORE: f64 = 1.3;

/// Grade of the solution, out of 100, below which no scaling is graded.
const FIT: f64 = 75.0;

pub(crate) fn scaling(runs: &Runs<'_>) -> Result<Found, Without> {
    let own = runs.of(Whose::Own).filter(|run| run.n == runs.timed.n);
    let mut workers: Vec<usize> = own.map(|run| run.workers).filter(|p| *p > 1).collect();
    workers.sort_unstable();
    let Some(greatest) = workers.last() else {
        return Err((Verdict::NotTimed, "it was timed on a machine with one core".into()));
    };
    let own = Efficiencies::of(runs, Whose::Own, &workers)?;
    let theirs = Efficiencies::of(runs, Whose::Solution, &workers)?;
    // Grades are relative to the solution's grade, because no student can reach a better one on
    // this machine.
    let own_grade = own.grade();
    let most = theirs.grade();
    if let Some(most) = [most.min, most.median].into_iter().find(|most| *most < FIT) {
        let busy = runs.find(Whose::Solution, runs.timed.n, *greatest).map_or(0.0, busy);
        let why = format!(
            "the solution itself gets {most:.0} of 100 for its scaling here, with {busy:.1} of {greatest} processors \
             busy: something else runs, or this machine has fewer cores than it says"
        );
        return Err((Verdict::TooNoisy, why));
    }
    let mut words = format!(
        "average efficiency on up to {greatest} workers against the serial program: strong \
         {:.2}, weak {:.2}; the solution's: {:.2} and {:.2}",
        own.strong.min, own.weak.min, theirs.strong.min, theirs.weak.min
    );
    if own.strong.min == 0.0 || own.weak.min == 0.0 {
        words +=
            "; workers that are together no faster than one, or of whom one works, do not scale";
    }
    Ok(Found { grade: Span::both(|way| (100.0 * way(&own_grade) / way(&most)).min(100.0)), words })
}

/// Efficiencies of a program, averaged over the numbers of workers.
struct Efficiencies {
    strong: Span,
    weak: Span,
}

impl Efficiencies {
    fn of(runs: &Runs<'_>, whose: Whose, workers: &[usize]) -> Result<Self, Without> {
        let n = runs.timed.n;
        let each = (n / workers.last().unwrap_or(&1)).max(1);
        let mut strong = Vec::new();
        let mut weak = Vec::new();
        for &p in workers {
            let run = runs.find(whose, n, p)?;
            strong.push(efficiency(runs, run, n, |one, all| strong_efficiency(one, p, all))?);
            let run = runs.find(whose, each * p, p)?;
            weak.push(efficiency(runs, run, each, weak_efficiency)?);
        }
        let nothing = Span { min: 0.0, median: 0.0 };
        Ok(Self {
            strong: averages(&strong).unwrap_or(nothing),
            weak: averages(&weak).unwrap_or(nothing),
        })
    }

    fn grade(&self) -> Span {
        Span::both(|way| scaling_grade(way(&self.strong), way(&self.weak)))
    }
}

/// Returns the efficiency of a run, compared with the serial program on a scene of `alone`
/// particles; 0 if only one worker works.
fn efficiency(
    runs: &Runs<'_>,
    run: &Run,
    alone: usize,
    of_seconds: impl Fn(f64, f64) -> f64,
) -> Result<Span, Without> {
    let least = if run.whose == Whose::Own { MORE_THAN_ONE } else { CLEARLY_MORE };
    let one = runs.time(Whose::Serial, alone, 1)?;
    let all = runs.seconds(run)?;
    Ok(Span::both(|way| {
        let efficiency = of_seconds(way(&one), way(&all));
        let is_one = busy(run) < least || run.workers as f64 * efficiency < MORE_THAN_ONE;
        if is_one { 0.0 } else { efficiency }
    }))
}
