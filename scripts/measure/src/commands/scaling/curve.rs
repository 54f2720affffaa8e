//! One variant's times over the numbers of workers, and what they are worth.

use crate::rounds::Measured;
use crate::rubric::{average, efficiency_grade, scaling_grade, strong_efficiency, weak_efficiency};
use lab_kit::machine::cores;
use lab_kit::program::Program;

/// A variant's strong and weak scaling.
pub(super) struct Curve {
    pub(super) program: Program,
    pub(super) strong: Vec<Point>,
    pub(super) weak: Vec<Point>,
}

/// One number of workers.
pub(super) struct Point {
    pub(super) workers: usize,
    pub(super) measured: Measured,
    /// Efficiency against the serial program, by the shortest takes.
    pub(super) efficiency: f64,
    /// The same by the medians.
    efficiency_of_medians: f64,
    /// Efficiency against the variant's own one worker.
    pub(super) own_efficiency: f64,
}

/// The grade of a curve and the averages it comes from.
pub(super) struct Verdict {
    pub(super) strong: f64,
    pub(super) weak: Option<f64>,
    pub(super) grade: f64,
    /// What the medians would give.
    pub(super) grade_of_medians: f64,
}

/// Serial run, and runs by number of workers.
type Runs<'m> = (Option<&'m Measured>, Vec<(usize, &'m Measured)>);

impl Curve {
    pub(super) fn new(program: Program, strong: Runs<'_>, weak: Runs<'_>) -> Self {
        let strong = points(strong, strong_efficiency);
        let weak = points(weak, |one, _, all| weak_efficiency(one, all));
        Self { program, strong, weak }
    }

    /// Grades the numbers of workers that this machine has cores for.
    pub(super) fn verdict(&self) -> Option<Verdict> {
        let mean = |points: &[Point], of: fn(&Point) -> f64| {
            average(&points.iter().filter(|p| p.graded()).map(of).collect::<Vec<_>>())
        };
        let grade = |strong, weak: Option<f64>| {
            weak.map_or_else(|| efficiency_grade(strong), |weak| scaling_grade(strong, weak))
        };
        let by_min: fn(&Point) -> f64 = |p| p.efficiency;
        let by_median: fn(&Point) -> f64 = |p| p.efficiency_of_medians;
        let (strong, weak) = (mean(&self.strong, by_min)?, mean(&self.weak, by_min));
        let medians = (mean(&self.strong, by_median)?, mean(&self.weak, by_median));
        Some(Verdict {
            strong,
            weak,
            grade: grade(strong, weak),
            grade_of_medians: grade(medians.0, medians.1),
        })
    }
}

impl Point {
    /// More workers than cores are shown, not graded.
    pub(super) fn graded(&self) -> bool {
        self.measured.job.all_workers() <= cores()
    }
}

fn points((one, all): Runs<'_>, efficiency: fn(f64, usize, f64) -> f64) -> Vec<Point> {
    let own = all.iter().find(|(workers, _)| *workers == 1).map(|(_, measured)| *measured);
    let against = |one: Option<&Measured>, p, measured: &Measured| {
        one.map_or(f64::NAN, |one| efficiency(one.times.min(), p, measured.times.min()))
    };
    all.into_iter()
        .map(|(workers, measured)| Point {
            workers,
            measured: measured.clone(),
            efficiency: against(one, workers, measured),
            efficiency_of_medians: one.map_or(f64::NAN, |one| {
                efficiency(one.times.median(), workers, measured.times.median())
            }),
            own_efficiency: against(own, workers, measured),
        })
        .collect()
}
