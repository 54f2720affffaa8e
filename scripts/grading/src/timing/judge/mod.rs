//! Computes grades from times.

mod complexity;
#[cfg(test)]
mod grade_tests;
mod runs;
mod scaling;

use crate::record::{Findings, Kind, Measure, Outcome, Run, Status, Verdict, Whose};
use crate::timing::plan::drawn;
use lab_kit::Facts;
use lab_kit::facts::Timed;
use lab_measure::autograder::efficiency_grade;
use lab_measure::clock::{self, Span};

use runs::Runs;
pub(crate) use runs::seconds_of;

/// Result of a measure: the grade, and the measurement in words.
struct Found {
    grade: Span,
    words: String,
}

/// Reason why there is no grade.
type Without = (Verdict, String);

/// Judges all measures of a rubric from the runs in a record.
pub(crate) fn judge(findings: &Findings, rubric: &Facts) -> Vec<Measure> {
    let rubric = drawn(rubric, findings.seed);
    let found = all(findings, &rubric).into_iter();
    found.map(|(kind, timed, found)| measure(&findings.runs, kind, timed, found)).collect()
}

/// Whether further takes may improve a grade, because some times are noisy.
pub(crate) fn is_noisy(findings: &Findings, rubric: &Facts) -> bool {
    all(findings, &drawn(rubric, findings.seed)).iter().any(|(_, _, found)| match found {
        Ok(found) => clock::is_noisy(found.grade),
        Err((verdict, _)) => *verdict == Verdict::TooNoisy,
    })
}

type Judged<'r> = (Kind, &'r Timed, Result<Found, Without>);

fn all<'r>(findings: &Findings, rubric: &'r Facts) -> Vec<Judged<'r>> {
    type Judge = fn(&Runs<'_>) -> Result<Found, Without>;
    let all: [(Kind, &Option<Timed>, Judge); 3] = [
        (Kind::Complexity, &rubric.complexity, complexity::complexity),
        (Kind::Scaling, &rubric.scaling, scaling::scaling),
        (Kind::Speed, &rubric.speed, speed),
    ];
    let mut found = Vec::new();
    for (kind, timed, judge) in all {
        let Some(timed) = timed else { continue };
        let result = if !findings.timed {
            Err((Verdict::NotTimed, "no times were taken".into()))
        } else if findings.status != Status::Graded {
            Err((Verdict::Wrong, "there is no program to time".into()))
        } else {
            judge(&Runs { all: &findings.runs, timed })
        };
        found.push((kind, timed, result));
    }
    for (kind, _, found) in found.iter_mut().filter(|_| !rubric.races.is_empty()) {
        if let (Kind::Speed, Ok(found)) = (*kind, found) {
            let which = format!("; 'cargo lab speed {}' says which loop is slow", findings.lab);
            found.words += &which;
        }
    }
    // A machine that is unfit for scaling is unfit for speed too.
    let unfit = found.iter().find_map(|(_, _, found)| match found {
        Err(unfit) if unfit.0 == Verdict::TooNoisy => Some(unfit.clone()),
        _ => None,
    });
    let speed = found.iter_mut().find(|(kind, _, found)| *kind == Kind::Speed && found.is_ok());
    if let Some(((_, _, speed), unfit)) = speed.zip(unfit) {
        *speed = Err(unfit);
    }
    found
}

/// Grades the time relative to the solution's time.
fn speed(runs: &Runs<'_>) -> Result<Found, Without> {
    let n = runs.timed.n;
    let most = runs.of(Whose::Own).filter(|run| run.n == n).map(|run| run.workers).max();
    let workers = most.ok_or_else(|| runs.not_timed(n))?;
    let own = runs.find(Whose::Own, n, workers)?;
    if own.outcome == Outcome::TooSlow {
        return Ok(Found { grade: Span { min: 0.0, median: 0.0 }, words: own.message.clone() });
    }
    let times = runs.seconds(own)?.over(runs.time(Whose::Solution, n, workers)?);
    let times = Span { min: times.of_minima, median: times.of_medians };
    let words = format!("it takes {:.2} times as long as the solution", times.min);
    Ok(Found { grade: Span::both(|way| efficiency_grade(1.0 / way(&times))), words })
}

/// Makes a measure from a grade.
///
/// If the times are noisy and the solution's times are quiet, the submission causes the noise, and
/// its medians count. If the solution's times are noisy too, there is no grade.
fn measure(runs: &[Run], kind: Kind, timed: &Timed, found: Result<Found, Without>) -> Measure {
    let (verdict, grade, message) = match found {
        Ok(Found { grade, words }) if clock::is_noisy(grade) => {
            let Span { min: by_min, median: by_median } = grade;
            let both = format!(
                "{by_min:.0} of 100 by the shortest takes, {by_median:.0} by the medians ({words})"
            );
            if (Runs { all: runs, timed }).is_quiet() {
                let why =
                    format!("the medians count: {both}, and the solution's times beside it agree");
                (Verdict::Graded, Some(by_min.min(by_median)), why)
            } else {
                let why =
                    format!("too noisy to grade: {both}. Grade again while the machine is idle");
                (Verdict::TooNoisy, None, why)
            }
        }
        Ok(Found { grade, words }) => (Verdict::Graded, Some(grade.min), words),
        Err((verdict, why)) => (verdict, (verdict == Verdict::Wrong).then_some(0.0), why),
    };
    // Round to two decimals, because half points occur and sixteen digits would only confuse.
    let points = (timed.points * grade.unwrap_or(0.0)).round() / 100.0;
    let variant = timed.variant.clone();
    Measure { kind, variant, verdict, message, grade, points, out_of: timed.points }
}
