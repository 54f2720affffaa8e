//! Grade of scaling: how much faster a program is with more workers.

use super::runs::{Runs, busy};
use super::{Found, Without};
use crate::record::{Verdict, Whose};
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
    let own = average_efficiencies(runs, Whose::Own, &workers)?;
    let theirs = average_efficiencies(runs, Whose::Solution, &workers)?;
    let grade =
        |[strong, weak]: &[Span; 2]| Span::both(|way| scaling_grade(way(strong), way(weak)));
    // Grades are relative to the solution's grade, because no student can reach a better one on
    // this machine.
    let own_grade = grade(&own);
    let most = grade(&theirs);
    if let Some(most) = [most.min, most.median].into_iter().find(|most| *most < FIT) {
        let busy = runs.find(Whose::Solution, runs.timed.n, *greatest).map_or(0.0, busy);
        let why = format!(
            "the solution itself gets {most:.0} of 100 for its scaling here, with {busy:.1} of {greatest} processors \
             busy: something else runs, or this machine has fewer cores than it says"
        );
        return Err((Verdict::TooNoisy, why));
    }
    let [[strong, weak], [their_strong, their_weak]] = [own, theirs].map(|of| of.map(|e| e.min));
    let mut words = format!(
        "average efficiency on up to {greatest} workers against the serial program: strong \
         {strong:.2}, weak {weak:.2}; the solution's: {their_strong:.2} and {their_weak:.2}"
    );
    if strong == 0.0 || weak == 0.0 {
        words +=
            "; workers that are together no faster than one, or of whom one works, do not scale";
    }
    Ok(Found { grade: Span::both(|way| (100.0 * way(&own_grade) / way(&most)).min(100.0)), words })
}

/// Returns the strong-scaling and the weak-scaling efficiency, averaged over the numbers of
/// workers.
fn average_efficiencies(
    runs: &Runs<'_>,
    whose: Whose,
    workers: &[usize],
) -> Result<[Span; 2], Without> {
    let n = runs.timed.n;
    let each = (n / workers.last().unwrap_or(&1)).max(1);
    let least = if whose == Whose::Own { MORE_THAN_ONE } else { CLEARLY_MORE };
    let mut found: [Vec<Span>; 2] = Default::default();
    for &p in workers {
        let of = |alone, together, efficiency: &dyn Fn(f64, f64) -> f64| {
            let run = runs.find(whose, together, p)?;
            let one = runs.time(Whose::Serial, alone, 1)?;
            let all = runs.seconds(run)?;
            Ok(Span::both(|way| {
                let efficiency = efficiency(way(&one), way(&all));
                let is_one = busy(run) < least || p as f64 * efficiency < MORE_THAN_ONE;
                if is_one { 0.0 } else { efficiency }
            }))
        };
        found[0].push(of(n, n, &|one, all| strong_efficiency(one, p, all))?);
        found[1].push(of(each, each * p, &weak_efficiency)?);
    }
    let nothing = Span { min: 0.0, median: 0.0 };
    Ok(found.map(|efficiencies| averages(&efficiencies).unwrap_or(nothing)))
}
