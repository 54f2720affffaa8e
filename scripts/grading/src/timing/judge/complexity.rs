//! How the time grows with the number of particles.

use super::runs::{longest, net, own, solution};
use super::{Found, WAYS, Without};
use crate::record::{Outcome, Run};
use crate::timing::plan::sizes;
use lab_kit::rubric::Timed;
use lab_measure::rubric::{complexity_grade, slope};

/// A program that dawdles on small scenes looks flat. One that takes so many times the solution's time
/// on the largest scene is judged by a line that begins at the solution's time on the smallest.
const DAWDLE: f64 = 10.0;

pub(crate) fn complexity(runs: &[Run], timed: &Timed) -> Result<Found, Without> {
    let sizes = sizes(timed.n);
    let mut points: [Vec<(f64, f64)>; 2] = Default::default();
    let mut pairs = Vec::new();
    let mut slow = None;
    for &n in &sizes {
        let own = own(runs, timed, n, 1)?;
        if own.outcome == Outcome::TooSlow {
            // It took longer than this, so the slope is steeper still.
            slow = Some(own);
            points.iter_mut().for_each(|points| points.push((n as f64, longest(own))));
            break;
        }
        for (points, way) in points.iter_mut().zip(WAYS) {
            points.push((n as f64, net(runs, own, way)?));
        }
        let counted = own.counted.get("pair tests per particle and step");
        pairs.extend(counted.map(|tests| (n as f64, n as f64 * tests)));
    }
    if points[0].len() < 3 {
        let why = "too slow to see how its time grows".to_owned();
        return Ok(Found { grades: [0.0; 2], words: why });
    }
    let mut slopes = [0.0; 2];
    let mut dawdles = false;
    for ((slope_of, points), way) in slopes.iter_mut().zip(&points).zip(WAYS) {
        *slope_of = slope(points);
        let Some(&last) = points.last() else { continue };
        let solution = |n| net(runs, solution(runs, timed, n, 1)?, way);
        if last.1 > DAWDLE * solution(last.0 as usize)? {
            let from_solution = slope(&[(sizes[0] as f64, solution(sizes[0])?), last]);
            dawdles |= from_solution > *slope_of;
            *slope_of = slope_of.max(from_solution);
        }
    }
    let mut words = format!(
        "the time grows as n to the power {:.2}, from {} to {} particles",
        slopes[0], sizes[0], timed.n
    );
    if pairs.len() > 2 {
        words += &format!("; the pairs that it counts, as n to the power {:.2}", slope(&pairs));
    }
    if dawdles {
        words += "; it is so slow on the largest scene that the line begins at the solution's time";
    }
    if let Some(slow) = slow {
        words += &format!("; at n = {} there was {}", slow.n, slow.message);
    }
    Ok(Found { grades: slopes.map(complexity_grade), words })
}
