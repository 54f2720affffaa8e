//! Times of a program for all sizes, and the slope of the line through them.

use anyhow::Result;
use lab_kit::program::Program;
use lab_kit::table::Table;
use serde::{Deserialize, Serialize};

use crate::autograder::{complexity_grade, slope, slopes};
use crate::clock::{Span, TOO_SHORT, warning};
use crate::columns::Columns;
use crate::experiment::{Timing, Timings};
use crate::job::Job;
use crate::runner::Runner;

/// Times of a program for all sizes.
#[derive(Deserialize, Serialize)]
pub(super) struct Line {
    pub(super) program: Program,
    pub(super) workers: usize,
    pub(super) slope_by_time: f64,
    slope_by_median: f64,
    slope_by_pair_tests: Option<f64>,
    grade: f64,
    pub(super) points: Vec<Point>,
}

#[derive(Deserialize, Serialize)]
pub(super) struct Point {
    #[serde(flatten)]
    pub(super) timing: Timing,
    /// Number of pairs tested in a step; `None` if the program does not count them.
    pair_tests_per_step: Option<f64>,
}

impl Line {
    /// Fits slopes to the times, and counts the pairs in separate short runs.
    pub(super) fn new(runner: &Runner, timings: &[Timing]) -> Result<Self> {
        let Job { program, workers, .. } = timings[0].job.clone();
        let mut points = Vec::new();
        let mut times = Vec::new();
        let mut pairs = Vec::new();
        for timing in timings {
            let pair_tests_per_step = pair_tests(runner, &timing.job)?;
            let point = Point { timing: timing.clone(), pair_tests_per_step };
            times.push((point.n(), timing.ms()));
            pairs.extend(pair_tests_per_step.map(|pairs| (point.n(), pairs)));
            points.push(point);
        }
        let by_time = slopes(&times);
        Ok(Self {
            program,
            workers,
            slope_by_time: by_time.min,
            slope_by_median: by_time.median,
            slope_by_pair_tests: (pairs.len() > 1).then(|| slope(&pairs)),
            grade: complexity_grade(by_time.min),
            points,
        })
    }

    /// Returns the program's name in tables and in the chart.
    pub(super) fn name(&self) -> String {
        match self.workers {
            1 => self.program.to_string(),
            p if self.program.has_ranks() => format!("{}, {p} ranks", self.program),
            p => format!("{}, {p} threads", self.program),
        }
    }

    pub(super) fn verdict(&self) -> String {
        let Self { slope_by_time, slope_by_median, grade, .. } = self;
        let pairs = self.slope_by_pair_tests.map_or_else(String::new, |slope| {
            format!(",\nthe pairs that are looked at, averaged over 100 steps at most, as n to the power {slope:.3}")
        });
        let by_median = complexity_grade(*slope_by_median);
        let spread = warning(Span { min: *grade, median: by_median }, *slope_by_median);
        let grade = match self.points.iter().any(|point| point.timing.times.are_too_short()) {
            true => TOO_SHORT.into(),
            false => format!("Grade: {grade:.2} of 100.{spread}"),
        };
        format!("The time grows as n to the power {slope_by_time:.3}{pairs}. {grade}")
    }

    pub(super) fn table(&self, timings: &Timings) -> Table {
        let all = self.workers > 1;
        Columns::of("n", |point: &Point| point.n().to_string())
            .text("steps", |point| point.timing.job.steps.to_string())
            .times("ms a step: ", |point| point.timing.ms())
            .perhaps("slope", |point| self.slope_to(point, |point| Some(point.timing.ms().min)))
            .number("ns per particle", |point| Some(point.timing.nanoseconds.min))
            .number("pair tests per particle", |point| Some(point.pair_tests_per_step? / point.n()))
            .perhaps("slope", |point| self.slope_to(point, |point| point.pair_tests_per_step))
            .number("streaming bound [ns]", |point| Some(timings.bound(point.n() as usize, all)))
            .table(&self.points)
    }

    /// Returns the slope of `y` from the previous point to `point`; `None` if one of them has no
    /// `y`.
    fn slope_to(&self, point: &Point, y: fn(&Point) -> Option<f64>) -> Option<String> {
        let at = self.points.iter().position(|other| std::ptr::eq(other, point))?;
        let before = self.points.get(at.checked_sub(1)?)?;
        let slope = slope(&[(before.n(), y(before)?), (point.n(), y(point)?)]);
        Some(format!("{slope:.2}"))
    }
}

impl Point {
    pub(super) fn n(&self) -> f64 {
        self.timing.job.scene.n() as f64
    }
}

/// Counts the pairs that are tested in a step.
///
/// The count is an average over some steps, because the start, a lattice, is not typical of the
/// scene.
fn pair_tests(runner: &Runner, job: &Job) -> Result<Option<f64>> {
    let few = job.steps.min(100);
    let statistics = !job.program.is_hard();
    let output = runner.run(&Job { steps: few, statistics, ..job.clone() })?;
    let counted = output.counters.get("pair tests").map(|total| total / few as f64);
    let averaged = output.statistics.map(|all| all.pair_tests * job.scene.n() as f64);
    Ok(averaged.or(counted))
}
