//! How long it takes beside the solution.

use super::runs::Runs;
use super::{Found, Without};
use crate::record::{Outcome, Whose};
use lab_measure::clock::Span;
use lab_measure::rubric::efficiency_grade;

pub(crate) fn speed(runs: &Runs<'_>) -> Result<Found, Without> {
    let n = runs.timed.n;
    let most = runs.of(Whose::Own).filter(|run| run.n == n).map(|run| run.workers).max();
    let workers = most.ok_or_else(|| runs.not_timed(n))?;
    let own = runs.find(Whose::Own, n, workers)?;
    if own.outcome == Outcome::TooSlow {
        return Ok(Found { grade: Span { min: 0.0, median: 0.0 }, words: own.message.clone() });
    }
    let times = runs.seconds(own)?.over(runs.solution(n, workers)?);
    let times = Span { min: times.of_minima, median: times.of_medians };
    let words = format!("it takes {:.2} times as long as the solution", times.min);
    Ok(Found { grade: Span::both(|way| efficiency_grade(1.0 / way(&times))), words })
}
