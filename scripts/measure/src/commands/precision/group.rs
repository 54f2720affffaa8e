//! Run times and errors of all programs for one n.

use lab_kit::program::Program;
use serde::{Deserialize, Serialize};

use crate::clock::Times;

/// The points for one n, and the error of the reference.
#[derive(Deserialize, Serialize)]
pub(crate) struct Group {
    pub(super) n: u64,
    pub(super) reference_error: f64,
    pub(super) points: Vec<Point>,
}

/// Time and error of a program for one n.
#[derive(Deserialize, Serialize)]
pub(crate) struct Point {
    pub(super) program: Program,
    pub(super) n: u64,
    pub(super) divide: u32,
    /// Root mean square distance from the exact positions.
    pub(super) rms_error: f64,
    pub(super) seconds: Times,
    pub(super) force_evaluations: f64,
    /// Greatest |ΔE/E| at t = 1 over the seeds; `None` if it was not measured.
    pub(super) energy_drift: Option<f64>,
    /// Whether the point is on the Pareto front.
    ///
    /// If so, no other point is at least as good in both seconds and error, and better in one of
    /// them.
    pub(super) on_front: bool,
}

impl Group {
    /// Marks the points on the front.
    pub(super) fn new(n: u64, reference_error: f64, mut points: Vec<Point>) -> Self {
        let costs: Vec<_> = points.iter().map(|p| (p.seconds.min, p.rms_error)).collect();
        for (point, on_front) in points.iter_mut().zip(front(&costs)) {
            point.on_front = on_front;
        }
        Self { n, reference_error, points }
    }
}

/// Returns for each point (cost, error) whether it is on the Pareto front. A point that is not
/// finite is never on the front.
pub(crate) fn front(points: &[(f64, f64)]) -> Vec<bool> {
    let mut front = Vec::new();
    for p in points {
        let is_beaten = points.iter().any(|other| beats(other, p));
        front.push(p.0.is_finite() && p.1.is_finite() && !is_beaten);
    }
    front
}

fn beats(a: &(f64, f64), b: &(f64, f64)) -> bool {
    a.0 <= b.0 && a.1 <= b.1 && (a.0 < b.0 || a.1 < b.1)
}

#[cfg(test)]
mod tests {
    use super::front;

    #[test]
    fn the_front_is_what_no_other_point_beats() {
        let points = [(1.0, 9.0), (2.0, 5.0), (2.0, 6.0), (3.0, 5.0), (4.0, 1.0), (0.5, f64::NAN)];
        assert_eq!(front(&points), [true, true, false, false, true, false]);
        assert_eq!(front(&[(1.0, 1.0), (1.0, 1.0)]), [true, true]);
    }
}
