//! One variant's times over the numbers of workers, and what they are worth.

use crate::clock::Span;
use crate::experiment::Record;
use crate::rubric::{
    averages, efficiency_grade, scaling_grade, strong_efficiency, weak_efficiency,
};
use lab_kit::machine::cores;
use lab_kit::program::Program;
use serde::{Deserialize, Serialize};

/// A variant's strong and weak scaling. Its grade counts the numbers of workers that this machine has cores
/// for; there is none without any.
#[derive(Deserialize, Serialize)]
pub(super) struct Curve {
    pub(super) program: Program,
    pub(super) strong: Vec<Point>,
    pub(super) weak: Vec<Point>,
    pub(super) average_strong_efficiency: Option<f64>,
    pub(super) average_weak_efficiency: Option<f64>,
    grade: Option<f64>,
    /// By the shortest takes, and by the medians.
    #[serde(skip)]
    pub(super) grades: Option<Span>,
}

/// One number of workers.
#[derive(Deserialize, Serialize)]
pub(super) struct Point {
    pub(super) workers: usize,
    #[serde(flatten)]
    pub(super) record: Record,
    /// Efficiency against the serial program, by the shortest takes.
    pub(super) efficiency: f64,
    #[serde(skip)]
    efficiencies: Option<Span>,
    /// Efficiency against the variant's own one worker.
    pub(super) own_efficiency: f64,
    /// More workers than cores are shown, not graded.
    pub(super) graded: bool,
}

/// Serial run, and runs by number of workers.
type Runs<'m> = (Option<&'m Record>, Vec<(usize, &'m Record)>);

impl Curve {
    pub(super) fn new(program: Program, strong: Runs<'_>, weak: Runs<'_>) -> Self {
        let strong = points(strong, strong_efficiency);
        let weak = points(weak, |one, _, all| weak_efficiency(one, all));
        let (of_strong, of_weak) = (mean(&strong, 1), mean(&weak, 1));
        let too_short = |point: &Point| point.graded && point.record.times.are_too_short();
        let is_too_short = strong.iter().chain(&weak).any(too_short);
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

    /// Average strong and weak efficiency as marks count them: one worker alone shows nothing of scaling.
    pub(super) fn for_marks(&self) -> (Option<f64>, Option<f64>) {
        let of = |points: &[Point]| mean(points, 2).map(|average| average.min);
        (of(&self.strong), of(&self.weak))
    }
}

/// The average over those numbers of workers, `least` or more, that are graded.
fn mean(points: &[Point], least: usize) -> Option<Span> {
    let graded = points.iter().filter(|point| point.graded && point.workers >= least);
    averages(&graded.filter_map(|point| point.efficiencies).collect::<Vec<_>>())
}

fn points((one, all): Runs<'_>, efficiency: fn(f64, usize, f64) -> f64) -> Vec<Point> {
    let own = all.iter().find(|(workers, _)| *workers == 1).map(|(_, record)| *record);
    let point = |&(workers, record): &(usize, &Record)| {
        let against = |one: Option<&Record>| {
            let (one, all) = (one?.times.span(1.0), record.times.span(1.0));
            Some(Span::both(|way| efficiency(way(&one), workers, way(&all))))
        };
        let shortest = |of: Option<Span>| of.map_or(f64::NAN, |efficiency| efficiency.min);
        let efficiencies = against(one);
        Point {
            workers,
            record: record.clone(),
            efficiency: shortest(efficiencies),
            efficiencies,
            own_efficiency: shortest(against(own)),
            graded: record.job.all_workers() <= cores(),
        }
    };
    all.iter().map(point).collect()
}
