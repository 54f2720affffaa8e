//! Grade of complexity: how the time grows with the number of particles.

use super::runs::{Runs, waited};
use super::{Found, Without};
use crate::record::{Outcome, Whose};
use crate::timing::plan::sizes;
use lab_measure::autograder::{complexity_grade, slopes};
use lab_measure::clock::Span;

/// Ratio to the solution's time at which the grader suspects a program of waiting.
///
/// A program that waits on small scenes appears to scale well. If such a program takes this
/// multiple of the solution's time on the largest scene, its slope is computed from the solution's
/// time on the smallest scene.
const DAWDLE: f64 = 10.0;

pub(crate) fn complexity(runs: &Runs<'_>) -> Result<Found, Without> {
    let sizes = sizes(runs.timed.n);
    let mut points: Vec<(f64, Span)> = Vec::new();
    let mut slow = None;
    let mut waits = Vec::new();
    for &n in &sizes {
        let own = runs.find(Whose::Own, n, 1)?;
        if own.outcome == Outcome::TooSlow {
            // The program took longer than this, so the real slope is even steeper.
            slow = Some(own);
            let longest = own.seconds.iter().copied().fold(0.0, f64::max);
            points.push((n as f64, Span { min: longest, median: longest }));
            break;
        }
        let mut seconds = runs.seconds(own)?;
        if let Some(share) = waited(own) {
            seconds = Span::both(|way| share * way(&seconds));
            waits.push(n.to_string());
        }
        points.push((n as f64, seconds));
    }
    let (Some(&last), 3..) = (points.last(), points.len()) else {
        let why = "too slow to see how its time grows".to_owned();
        return Ok(Found { grade: Span { min: 0.0, median: 0.0 }, words: why });
    };
    let fitted = slopes(&points);
    let first = runs.time(Whose::Solution, sizes[0], 1)?;
    let from_solution = slopes(&[(points[0].0, first), last]);
    let theirs = runs.time(Whose::Solution, last.0 as usize, 1)?;
    let slope_of = Span::both(|way| {
        let slow = way(&last.1) > DAWDLE * way(&theirs);
        if slow { way(&fitted).max(way(&from_solution)) } else { way(&fitted) }
    });
    let dawdles = slope_of.min > fitted.min || slope_of.median > fitted.median;
    let mut words = format!(
        "the time grows as n to the power {:.2}, from {} to {} particles",
        slope_of.min, sizes[0], runs.timed.n
    );
    if dawdles {
        words += "; it is so slow on the largest scene that the line begins at the solution's time";
    }
    if !waits.is_empty() {
        words += &format!(
            "; its processor was idle at n = {}, and to wait is no work",
            waits.join(", ")
        );
    }
    if let Some(slow) = slow {
        words += &format!("; at n = {} there was {}", slow.n, slow.message);
    }
    Ok(Found { grade: Span::both(|way| complexity_grade(way(&slope_of))), words })
}
