//! Grades from times.

mod complexity;
mod runs;
mod scaling;
mod speed;
#[cfg(test)]
mod tests;

use crate::record::{Kind, Measure, Record, Run, Status, Verdict};
use lab_kit::rubric::{Rubric, Timed};
use lab_measure::clock::Times;

pub(crate) use runs::seconds_of;

/// Where the grade by the shortest takes and the grade by the medians are further apart, nothing
/// is graded.
const NOISE: f64 = 5.0;

/// The shortest take and the median.
type Of = fn(&Times) -> f64;
const WAYS: [Of; 2] = [Times::min, Times::median];

/// What a measure comes to: the grades both ways, and what was measured, in words.
struct Found {
    grades: [f64; 2],
    words: String,
}

/// Why there is no grade.
enum Without {
    NotTimed(String),
    Wrong(String),
}

/// The measures of a record by a rubric, from the runs that are in it.
pub(crate) fn judge(record: &Record, rubric: &Rubric) -> Vec<Measure> {
    type Judge = fn(&[Run], &Timed) -> Result<Found, Without>;
    let all: [(Kind, &Option<Timed>, Judge); 3] = [
        (Kind::Complexity, &rubric.complexity, complexity::complexity),
        (Kind::Scaling, &rubric.scaling, scaling::scaling),
        (Kind::Speed, &rubric.speed, speed::speed),
    ];
    let measure = |(kind, timed, judge): (Kind, &Option<Timed>, Judge)| {
        let timed = timed.as_ref()?;
        let found = if !record.timed {
            Err(Without::NotTimed("no times were taken".into()))
        } else if record.status != Status::Graded {
            Err(Without::Wrong("there is no program to time".into()))
        } else {
            judge(&record.runs, timed)
        };
        Some(measure(kind, timed, found))
    };
    all.into_iter().filter_map(measure).collect()
}

fn measure(kind: Kind, timed: &Timed, found: Result<Found, Without>) -> Measure {
    let (verdict, grade, message) = match found {
        Ok(Found { grades: [by_min, by_median], words }) => {
            if (by_min - by_median).abs() > NOISE {
                let why = format!(
                    "too noisy to grade: {by_min:.0} of 100 by the shortest takes, {by_median:.0} \
                     by the medians ({words}). Grade again while the machine is idle"
                );
                (Verdict::TooNoisy, None, why)
            } else {
                (Verdict::Graded, Some(by_min), words)
            }
        }
        Err(Without::Wrong(why)) => (Verdict::Wrong, Some(0.0), why),
        Err(Without::NotTimed(why)) => (Verdict::NotTimed, None, why),
    };
    // Two decimals: half points are given, and nobody adds up sixteen digits.
    let points = (timed.points * grade.unwrap_or(0.0)).round() / 100.0;
    let variant = timed.variant.clone();
    Measure { kind, variant, verdict, message, grade, points, out_of: timed.points }
}
