//! How many steps a run gets: as many as there is time for.

use anyhow::Result;
use clap::Args;
use lab_kit::Workers;

use super::job::Job;
use super::rubric::slope;
use super::runner::Runner;

/// The course reports ran 1,000 steps; more show nothing new.
pub const MOST_STEPS: u64 = 1000;

/// A single step may take this share of all the time.
const LONGEST: f64 = 1.0 / 20.0;

/// How long a measurement may take, as the command line says it. A command with other defaults says so by
/// `mut_arg`.
#[derive(Args, Clone, Copy)]
pub struct Effort {
    /// Time steps of every run [default: as many as the time allows, at most 1000]
    #[arg(long, value_name = "STEPS", value_parser = clap::value_parser!(u64).range(1..))]
    pub steps: Option<u64>,
    /// How often each run is repeated
    #[arg(long, default_value_t = 3, value_name = "ROUNDS", value_parser = clap::value_parser!(u16).range(1..))]
    pub rounds: u16,
    /// Seconds for all runs together, if --steps does not decide; one step each is the least
    #[arg(long, default_value_t = 60.0, value_name = "SECONDS")]
    pub seconds: f64,
}

/// How many steps jobs have, where nobody says.
#[derive(Clone, Copy)]
pub enum Fit {
    /// All the same: as many as suit the slowest of the programs, each in the first of its jobs.
    Alike,
    /// Each as many as its share of the time allows, at most `most`.
    Each {
        /// The upper limit.
        most: u64,
        /// Whether a scene on which a single step would take far too long, as with all pairs, is left out untried.
        affordable: bool,
    },
}

/// Jobs that are not measured, and why.
pub type LeftOut = Vec<(Job, String)>;

/// The number of steps, 1 to `most`, in which `job` runs for about `seconds`, and the seconds of one step. Tries it
/// out.
fn calibrate(runner: &Runner, job: &Job, seconds: f64, most: u64) -> Result<(u64, f64)> {
    let mut steps = 1;
    loop {
        let took = runner.run(&Job { steps, ..job.clone() })?.seconds.max(1e-9);
        let fitting = (steps as f64 * seconds / took) as u64;
        // A try of a few milliseconds says little: the first steps find cold caches.
        if took > 0.2 * seconds || steps == most {
            return Ok((fitting.clamp(1, most), took / steps as f64));
        }
        steps = fitting.clamp(steps + 1, 8 * steps).min(most);
    }
}

/// Seconds of a step of `job`, by what was tried on two smaller scenes: as its time grew between these, but at
/// least in proportion, and at worst four times for twice the particles.
fn foreseen(tried: &[(Job, f64)], job: &Job) -> Option<f64> {
    let point = |(job, seconds): &(Job, f64)| (job.scene.n() as f64, *seconds);
    let smaller: Vec<_> = tried.iter().filter(|(job2, _)| job2.is_like(job)).map(point).collect();
    let n = job.scene.n() as f64;
    let last = *smaller.iter().rfind(|(m, _)| *m < n)?;
    let before = *smaller.iter().rfind(|(m, _)| *m < last.0)?;
    Some(last.1 * (n / last.0).powf(slope(&[before, last]).clamp(1.0, 2.0)))
}

impl Effort {
    /// The jobs with their steps, and those that are left out.
    pub(crate) fn fitted(
        &self,
        runner: &Runner,
        mut jobs: Vec<Job>,
        fit: Fit,
    ) -> Result<(Vec<Job>, LeftOut)> {
        let share = self.seconds / (jobs.len() * usize::from(self.rounds)) as f64;
        let (most, affordable) = match fit {
            Fit::Each { most, affordable } => (most, affordable && self.steps.is_none()),
            Fit::Alike => {
                let fitting = |of: &[Job]| match self.steps {
                    Some(steps) => Ok(steps),
                    None => Ok(calibrate(runner, &of[0], share, MOST_STEPS)?.0),
                };
                let each = jobs.chunk_by(|a, b| a.program == b.program).map(fitting);
                let steps = each.collect::<Result<Vec<_>>>()?.into_iter().min().unwrap_or(1);
                jobs.iter_mut().for_each(|job| job.steps = steps);
                return Ok((jobs, Vec::new()));
            }
        };
        let longest = (2.0 * share).max(self.seconds * LONGEST);
        let (mut tried, mut left_out): (Vec<(Job, f64)>, LeftOut) = (Vec::new(), Vec::new());
        for job in jobs {
            let foreseen = foreseen(&tried, &job).filter(|step| affordable && *step > longest);
            if let Some(step) = foreseen {
                let allowed = format!("and --seconds {} allows {longest:.1}", self.seconds);
                let why = format!("left out: a step would take about {step:.1} s, {allowed}");
                left_out.push((job, why));
                continue;
            }
            match self.try_out(runner, &job, share, most) {
                Ok((steps, seconds)) => tried.push((Job { steps, ..job }, seconds)),
                Err(error) if job.program.workers == Workers::Device => {
                    left_out.push((job, refusal(&error)));
                }
                Err(error) => return Err(error),
            }
        }
        Ok((tried.into_iter().map(|(job, _)| job).collect(), left_out))
    }

    /// The steps of a job and the seconds of one; these are unknown if it is said how many. What a device
    /// refuses shows only when it is tried.
    fn try_out(&self, runner: &Runner, job: &Job, share: f64, most: u64) -> Result<(u64, f64)> {
        let Some(steps) = self.steps else { return calibrate(runner, job, share, most) };
        if job.program.workers == Workers::Device {
            runner.run(&Job { steps: 1, ..job.clone() })?;
        }
        Ok((steps, f64::NAN))
    }
}

/// A program's own words without its name.
fn refusal(error: &anyhow::Error) -> String {
    let words = error.root_cause().to_string();
    format!("not run: {}", words.split_once(" failed: ").map_or(&*words, |(_, words)| words))
}
