//! One variant's times over the numbers of workers, and what they are worth.

use crate::experiment::Record;
use crate::rubric::{average, efficiency_grade, scaling_grade, strong_efficiency, weak_efficiency};
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
    pub(super) grade: Option<f64>,
    /// What the medians would give.
    #[serde(skip)]
    pub(super) grade_of_medians: Option<f64>,
}

/// One number of workers.
#[derive(Deserialize, Serialize)]
pub(super) struct Point {
    pub(super) workers: usize,
    #[serde(flatten)]
    pub(super) record: Record,
    /// Efficiency against the serial program, by the shortest takes.
    pub(super) efficiency: f64,
    /// The same by the medians.
    #[serde(skip)]
    efficiency_of_medians: f64,
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
        let averages = |of| (mean(&strong, 1, of), mean(&weak, 1, of));
        let grade = |(strong, weak): (Option<f64>, Option<f64>)| match (strong?, weak) {
            (strong, None) => Some(efficiency_grade(strong)),
            (strong, Some(weak)) => Some(scaling_grade(strong, weak)),
        };
        let by_min = averages(|point| point.efficiency);
        let by_median = averages(|point| point.efficiency_of_medians);
        Self {
            program,
            average_strong_efficiency: by_min.0,
            average_weak_efficiency: by_min.1,
            grade: grade(by_min),
            grade_of_medians: grade(by_median),
            strong,
            weak,
        }
    }

    /// Average strong and weak efficiency as marks count them: one worker alone shows nothing of scaling.
    pub(super) fn for_marks(&self) -> (Option<f64>, Option<f64>) {
        let of = |points: &[Point]| mean(points, 2, |point| point.efficiency);
        (of(&self.strong), of(&self.weak))
    }
}

/// The average over those numbers of workers, `least` or more, that are graded.
fn mean(points: &[Point], least: usize, of: fn(&Point) -> f64) -> Option<f64> {
    let graded = points.iter().filter(|point| point.graded && point.workers >= least);
    average(&graded.map(of).collect::<Vec<_>>())
}

fn points((one, all): Runs<'_>, efficiency: fn(f64, usize, f64) -> f64) -> Vec<Point> {
    let own = all.iter().find(|(workers, _)| *workers == 1).map(|(_, record)| *record);
    let point = |&(workers, record): &(usize, &Record)| {
        let against = |one: Option<&Record>, of: fn(&Record) -> f64| {
            one.map_or(f64::NAN, |one| efficiency(of(one), workers, of(record)))
        };
        Point {
            workers,
            record: record.clone(),
            efficiency: against(one, |record| record.times.min()),
            efficiency_of_medians: against(one, |record| record.times.median()),
            own_efficiency: against(own, |record| record.times.min()),
            graded: record.job.all_workers() <= cores(),
        }
    };
    all.iter().map(point).collect()
}
