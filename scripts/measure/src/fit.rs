//! Chooses the number of steps of each run, so that a measurement fits into its time.

use anyhow::Result;
use clap::Args;
use lab_kit::Workers;

use super::autograder::slope;
use super::job::Job;
use super::runner::Runner;

/// Greatest number of steps of a run. The course reports ran 1,000 steps; more steps show nothing
/// new.
pub(crate) const MOST_STEPS: u64 = 1000;

/// Greatest share of the total time that a single step may take.
const LONGEST: f64 = 1.0 / 20.0;

/// The time that a measurement may take, as options. A command with other defaults sets them with
/// `mut_arg`.
#[derive(Args, Clone, Copy)]
pub(crate) struct Effort {
    /// Number of time steps of every run [default: as many as the time allows, at most 1000]
    #[arg(long, value_name = "STEPS", value_parser = clap::value_parser!(u64).range(1..))]
    pub(crate) steps: Option<u64>,
    /// Number of takes of each run
    #[arg(long, default_value_t = 3, value_name = "ROUNDS", value_parser = clap::value_parser!(u16).range(1..))]
    pub(crate) rounds: u16,
    /// Seconds for all runs together, if --steps is not set; every run takes at least one step
    #[arg(long, default_value_t = 60.0, value_name = "SECONDS")]
    pub(crate) seconds: f64,
}

/// The way to choose the numbers of steps, if the user does not set them.
#[derive(Clone, Copy)]
pub(crate) enum Fit {
    /// All jobs have the same number of steps. The first job of each program is tried, and the
    /// number suits the slowest program.
    Alike,
    /// Each job has as many steps as its share of the time allows, at most `most`.
    Each {
        most: u64,
        /// Whether to omit, without a try, scenes on which a single step would take far too long,
        /// as with all pairs.
        affordable: bool,
    },
}

/// Jobs that are not measured, and the reasons.
pub(crate) type LeftOut = Vec<(Job, String)>;

pub(crate) struct Fitted {
    pub(crate) jobs: Vec<Job>,
    pub(crate) left_out: LeftOut,
}

struct TriedOut {
    job: Job,
    /// Seconds of a step; NaN if the user sets the number of steps.
    step: f64,
}

impl Effort {
    /// Chooses the number of steps of each job.
    pub(crate) fn fitted(&self, runner: &Runner, jobs: Vec<Job>, fit: Fit) -> Result<Fitted> {
        let share = self.seconds / (jobs.len() * usize::from(self.rounds)) as f64;
        match fit {
            Fit::Alike => self.alike(runner, jobs, share),
            Fit::Each { most, affordable } => self.each(runner, jobs, share, most, affordable),
        }
    }

    fn alike(&self, runner: &Runner, mut jobs: Vec<Job>, share: f64) -> Result<Fitted> {
        let mut steps = self.steps.unwrap_or(MOST_STEPS);
        if self.steps.is_none() {
            for of_program in jobs.chunk_by(|a, b| a.program == b.program) {
                let tried = calibrated(runner, of_program[0].clone(), share, MOST_STEPS)?;
                steps = steps.min(tried.job.steps);
            }
        }
        jobs.iter_mut().for_each(|job| job.steps = steps);
        Ok(Fitted { jobs, left_out: Vec::new() })
    }

    /// Chooses the steps of each job separately. With `affordable`, and if the user has set no
    /// `--steps`, the function omits jobs whose steps would take far too long.
    fn each(
        &self,
        runner: &Runner,
        jobs: Vec<Job>,
        share: f64,
        most: u64,
        affordable: bool,
    ) -> Result<Fitted> {
        let longest = (2.0 * share).max(self.seconds * LONGEST);
        let is_limited = affordable && self.steps.is_none();
        let mut tried: Vec<TriedOut> = Vec::new();
        let mut left_out = Vec::new();
        for job in jobs {
            if let Some(step) = foreseen(&tried, &job).filter(|step| is_limited && *step > longest)
            {
                let allowed = format!("and --seconds {} allows {longest:.1}", self.seconds);
                let why = format!("left out: a step would take about {step:.1} s, {allowed}");
                left_out.push((job, why));
                continue;
            }
            match self.try_out(runner, job.clone(), share, most) {
                Ok(job) => tried.push(job),
                Err(error) if job.program.workers == Workers::Device => {
                    left_out.push((job, refusal(&error)));
                }
                Err(error) => return Err(error),
            }
        }
        Ok(Fitted { jobs: tried.into_iter().map(|tried| tried.job).collect(), left_out })
    }

    /// Tries a job, even if the user sets the number of steps. The reason is that a device refuses
    /// a job only when the job runs.
    fn try_out(&self, runner: &Runner, job: Job, share: f64, most: u64) -> Result<TriedOut> {
        let Some(steps) = self.steps else { return calibrated(runner, job, share, most) };
        if job.program.workers == Workers::Device {
            runner.run(&Job { steps: 1, ..job.clone() })?;
        }
        Ok(TriedOut { job: Job { steps, ..job }, step: f64::NAN })
    }
}

/// Chooses a number of steps from 1 to `most` with which the job runs for about `seconds`. Tries
/// the job.
fn calibrated(runner: &Runner, mut job: Job, seconds: f64, most: u64) -> Result<TriedOut> {
    job.steps = 1;
    loop {
        let took = runner.run(&job)?.seconds.max(1e-9);
        let step = took / job.steps as f64;
        let fitting = (seconds / step) as u64;
        // A run of a few milliseconds is not typical, because the first steps find cold caches.
        if took > 0.2 * seconds || job.steps == most {
            job.steps = fitting.clamp(1, most);
            return Ok(TriedOut { job, step });
        }
        job.steps = fitting.clamp(job.steps + 1, 8 * job.steps).min(most);
    }
}

/// Predicts the seconds of a step of `job` from two smaller scenes that were tried.
///
/// The prediction assumes that the time grows as it grew between these scenes, but at least in
/// proportion to n and at most in proportion to n².
fn foreseen(tried: &[TriedOut], job: &Job) -> Option<f64> {
    let alike = tried.iter().filter(|tried| tried.job.is_like(job));
    let points: Vec<_> = alike.map(|tried| (tried.job.scene.n() as f64, tried.step)).collect();
    let n = job.scene.n() as f64;
    let last = *points.iter().rfind(|point| point.0 < n)?;
    let before = *points.iter().rfind(|point| point.0 < last.0)?;
    Some(last.1 * (n / last.0).powf(slope(&[before, last]).clamp(1.0, 2.0)))
}

/// Returns a program's message without the program's name.
fn refusal(error: &anyhow::Error) -> String {
    let words = error.root_cause().to_string();
    format!("not run: {}", words.split_once(" failed: ").map_or(&*words, |(_, words)| words))
}
