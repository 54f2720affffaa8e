//! The times of a variant for several numbers of workers, and their grade.

use crate::autograder::{averages, efficiency_grade, scaling_grade};
use crate::clock::Span;
use crate::experiment::Timing;
use lab_kit::machine::cores;
use lab_kit::program::Program;
use serde::{Deserialize, Serialize};

/// A variant's strong and weak scaling.
///
/// The grade uses only numbers of workers for which this machine has enough cores. It is `None` if
/// there are no such numbers.
#[derive(Deserialize, Serialize)]
pub(super) struct Curve {
    pub(super) program: Program,
    pub(super) strong: Vec<Point>,
    pub(super) weak: Vec<Point>,
    pub(super) average_strong_efficiency: Option<f64>,
    pub(super) average_weak_efficiency: Option<f64>,
    grade: Option<f64>,
    /// The grades for the shortest takes and for the medians.
    #[serde(skip)]
    pub(super) grades: Option<Span>,
}

/// The run with one number of workers.
#[derive(Deserialize, Serialize)]
pub(super) struct Point {
    pub(super) workers: usize,
    #[serde(flatten)]
    pub(super) timing: Timing,
    /// Efficiency relative to the serial program, from the shortest takes.
    pub(super) efficiency: f64,
    #[serde(skip)]
    efficiencies: Option<Span>,
    /// Efficiency relative to the same variant with one worker.
    pub(super) own_efficiency: f64,
    /// Whether the point counts for the grade. Points with more workers than cores do not count.
    pub(super) graded: bool,
}

/// A function that computes an efficiency from the seconds of one worker, the number of workers,
/// and the seconds of all workers.
pub(super) type Efficiency = fn(f64, usize, f64) -> f64;

impl Curve {
    pub(super) fn new(program: Program, strong: Vec<Point>, weak: Vec<Point>) -> Self {
        let of_strong = mean(&strong, 1);
        let of_weak = mean(&weak, 1);
        let is_too_short = strong.iter().chain(&weak).any(Point::is_too_short);
        let grades = of_strong.filter(|_| !is_too_short).map(|strong| {
            Span::both(|way| match &of_weak {
                None => efficiency_grade(way(&strong)),
                Some(weak) => scaling_grade(way(&strong), way(weak)),
            })
        });
        Self {
            program,
            average_strong_efficiency: of_strong.map(|average| average.min),
            average_weak_efficiency: of_weak.map(|average| average.min),
            grade: grades.map(|grades| grades.min),
            grades,
            strong,
            weak,
        }
    }
}

/// Returns the average efficiency for marks, without the point of one worker.
pub(super) fn for_marks(points: &[Point]) -> Option<f64> {
    Some(mean(points, 2)?.min)
}

/// Averages the graded points with `least` or more workers.
fn mean(points: &[Point], least: usize) -> Option<Span> {
    let graded = points.iter().filter(|point| point.graded && point.workers >= least);
    averages(&graded.filter_map(|point| point.efficiencies).collect::<Vec<_>>())
}

/// Computes the efficiency of a run relative to a run of one worker.
fn against(one: Option<&Timing>, p: usize, all: &Timing, efficiency: Efficiency) -> Option<Span> {
    let one = one?.times.span(1.0);
    let all = all.times.span(1.0);
    Some(Span::both(|way| efficiency(way(&one), p, way(&all))))
}

impl Point {
    /// Compares a run with the serial program's run, and with the variant's own run on one worker.
    pub(super) fn new(
        workers: usize,
        timing: &Timing,
        [serial, own]: [Option<&Timing>; 2],
        efficiency: Efficiency,
    ) -> Self {
        let efficiencies = against(serial, workers, timing, efficiency);
        let own = against(own, workers, timing, efficiency);
        Self {
            workers,
            timing: timing.clone(),
            efficiency: efficiencies.map_or(f64::NAN, |efficiency| efficiency.min),
            efficiencies,
            own_efficiency: own.map_or(f64::NAN, |efficiency| efficiency.min),
            graded: timing.job.all_workers() <= cores(),
        }
    }

    fn is_too_short(&self) -> bool {
        self.graded && self.timing.times.are_too_short()
    }
}
