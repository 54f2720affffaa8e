//! How long it takes beside the solution.

use super::runs::{is, net, not_timed, own, solution};
use super::{Found, WAYS, Without};
use crate::record::{Outcome, Run, Whose};
use crate::timing::plan::STEPS;
use lab_kit::rubric::Timed;
use lab_measure::rubric::efficiency_grade;

pub(crate) fn speed(runs: &[Run], timed: &Timed) -> Result<Found, Without> {
    let all = runs.iter().filter(|run| is(run, Whose::Own, timed, STEPS) && run.n == timed.n);
    let Some(workers) = all.map(|run| run.workers).max() else {
        return Err(not_timed(timed, timed.n));
    };
    let own = own(runs, timed, timed.n, workers)?;
    if own.outcome == Outcome::TooSlow {
        return Ok(Found { grades: [0.0; 2], words: own.message.clone() });
    }
    let solution = solution(runs, timed, timed.n, workers)?;
    let mut times = [0.0; 2];
    for (times, way) in times.iter_mut().zip(WAYS) {
        *times = net(runs, own, way)? / net(runs, solution, way)?;
    }
    let words = format!("it takes {:.2} times as long as the solution", times[0]);
    Ok(Found { grades: times.map(|times| efficiency_grade(1.0 / times)), words })
}
