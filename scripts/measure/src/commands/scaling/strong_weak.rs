//! The plan of a scaling measurement: its scenes and numbers of workers.

use lab_kit::program::Program;

use super::curve::{Curve, Efficiency, Point};
use crate::autograder::{strong_efficiency, weak_efficiency};
use crate::experiment::{Timing, Timings};
use crate::job::Job;
use crate::scene::Scene;

pub(super) struct Plan {
    /// The serial program, whose time is t₁.
    pub(super) serial: Program,
    pub(super) programs: Vec<Program>,
    pub(super) workers: Vec<usize>,
    pub(super) strong: Scene,
    /// Scene of the weak scaling, for one worker.
    ///
    /// For hard discs it is `None` unless the user asks for it, because p times as many discs mean
    /// p² times as much work if all pairs are tested.
    pub(super) weak: Option<Scene>,
    /// Whether ranks record their activities.
    pub(super) events: bool,
}

impl Plan {
    /// Returns all runs. A run that strong and weak scaling share is in the list only once.
    pub(super) fn jobs(&self) -> Vec<Job> {
        let mut jobs = vec![self.strong_job(&self.serial, 1)];
        jobs.extend(self.weak_job(&self.serial, 1));
        for program in &self.programs {
            for &p in &self.workers {
                jobs.push(self.strong_job(program, p));
                jobs.extend(self.weak_job(program, p));
            }
        }
        let mut unique: Vec<Job> = Vec::new();
        for job in jobs {
            if !unique.contains(&job) {
                unique.push(job);
            }
        }
        unique
    }

    fn strong_job(&self, program: &Program, workers: usize) -> Job {
        let events = self.events && program.has_ranks();
        Job { workers, events, ..Job::new(program.clone(), self.strong.clone()) }
    }

    /// Returns a run of the weak scaling; `None` if there is no scene for it.
    fn weak_job(&self, program: &Program, workers: usize) -> Option<Job> {
        let scene = self.weak.clone()?.times(workers);
        Some(Job { scene, ..self.strong_job(program, workers) })
    }

    pub(super) fn curves(&self, timings: &Timings) -> Vec<Curve> {
        let mut curves = Vec::new();
        for program in &self.programs {
            let strong = self.points(program, strong_efficiency, |program, p| {
                timings.find(&self.strong_job(program, p))
            });
            let weak = self.points(
                program,
                |one, _, all| weak_efficiency(one, all),
                |program, p| timings.find(&self.weak_job(program, p)?),
            );
            curves.push(Curve::new(program.clone(), strong, weak));
        }
        curves
    }

    /// Makes a point for each number of workers with a run.
    fn points<'m>(
        &self,
        program: &Program,
        efficiency: Efficiency,
        run: impl Fn(&Program, usize) -> Option<&'m Timing>,
    ) -> Vec<Point> {
        let single = [run(&self.serial, 1), run(program, 1)];
        let mut points = Vec::new();
        for &p in &self.workers {
            points.extend(run(program, p).map(|run| Point::new(p, run, single, efficiency)));
        }
        points
    }
}
