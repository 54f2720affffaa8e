//! Experiments: jobs that take turns.
//!
//! A machine's speed changes with its clock, its temperature and its other programs. So jobs take
//! turns: each round runs every job once, so a slow minute of the machine affects all jobs. Every
//! other round runs the jobs in reverse order, so that no job always follows the same job. The
//! streaming bound is measured in turn, too.

use std::collections::BTreeMap;

use anyhow::Result;
use lab_kit::machine::cores;
use lab_kit::progress::progress;
use lab_kit::table::three_digits;
use lab_machine::streaming;
use serde::{Deserialize, Serialize};

use super::clock::{Span, Times};
use super::fit::{Effort, Fit, LeftOut};
use super::job::Job;
use super::runner::Runner;

/// Times of a job in all rounds.
#[derive(Clone, Debug, Deserialize, Serialize)]
pub(crate) struct Timing {
    #[serde(flatten)]
    pub(crate) job: Job,
    #[serde(skip_deserializing)]
    ranks: Option<usize>,
    #[serde(skip_deserializing)]
    threads: usize,
    #[serde(rename = "seconds")]
    pub(crate) times: Times,
    /// Counters of the shortest run.
    pub(crate) counters: BTreeMap<String, f64>,
    /// Nanoseconds per particle and step.
    #[serde(rename = "nanoseconds_per_particle_and_step")]
    pub(crate) nanoseconds: Span,
}

/// Nanoseconds per particle of the streaming bound.
#[derive(Clone, Copy, Debug, Deserialize, Serialize)]
pub struct Bound {
    /// Number of particles.
    pub n: usize,
    /// Number of threads.
    pub threads: usize,
    /// Nanoseconds per particle of the shortest take.
    pub nanoseconds: f64,
}

pub(crate) struct Timings {
    /// Timings in the order of the jobs.
    pub(crate) timings: Vec<Timing>,
    /// Streaming bounds in ascending order of n, each with one thread and with all threads.
    pub(crate) bounds: Vec<Bound>,
    /// Jobs that were not measured, and the reasons.
    pub(crate) left_out: LeftOut,
}

/// Returns the order of the jobs in a round, which is reversed in every other round.
pub fn turns(count: usize, round: usize) -> Vec<usize> {
    let mut order: Vec<usize> = (0..count).collect();
    if round % 2 == 1 {
        order.reverse();
    }
    order
}

/// Runs `items` in turns, for a number of rounds, and shows a progress bar with their names.
///
/// Returns the results of each item, round by round.
///
/// # Errors
/// A run fails.
pub fn in_turns<T, O>(
    items: &[T],
    rounds: usize,
    name: impl Fn(&T) -> String,
    mut run: impl FnMut(&T) -> Result<O>,
) -> Result<Vec<Vec<O>>> {
    let bar = progress((rounds * items.len()) as u64);
    let mut all: Vec<Vec<O>> = items.iter().map(|_| Vec::new()).collect();
    for round in 0..rounds {
        for at in turns(items.len(), round) {
            bar.set_message(name(&items[at]));
            all[at].push(run(&items[at])?);
            bar.inc(1);
        }
    }
    bar.finish_and_clear();
    Ok(all)
}

/// Runs `items` once each. Returns their results in order.
pub(crate) fn one_by_one<T, O>(
    items: &[T],
    name: impl Fn(&T) -> String,
    run: impl FnMut(&T) -> Result<O>,
) -> Result<Vec<O>> {
    Ok(in_turns(items, 1, name, run)?.into_iter().flatten().collect())
}

impl Effort {
    /// Runs all jobs and the streaming bound, round after round.
    pub(crate) fn run(&self, runner: &Runner, jobs: Vec<Job>, fit: Fit) -> Result<Timings> {
        if self.steps.is_none() {
            let runs = jobs.len() * usize::from(self.rounds);
            let seconds = self.seconds;
            eprintln!(
                "{runs} runs in some {seconds} s, after trying out how many steps each may have"
            );
        }
        let fitted = self.fitted(runner, jobs, fit)?;
        let jobs = fitted.jobs;
        let mut bounds = bounds_of(&jobs);
        let mut left = jobs.len();
        let runs = in_turns(&jobs, self.rounds.into(), Job::name, |job| {
            let run = runner.run(job)?;
            left -= 1;
            if left == 0 {
                left = jobs.len();
                bounds.iter_mut().for_each(Bound::take);
            }
            Ok(run)
        })?;
        let mut timings = Vec::new();
        for (job, mut runs) in jobs.into_iter().zip(runs) {
            runs.sort_by(|a, b| a.seconds.total_cmp(&b.seconds));
            let Some(times) = Times::of(runs.iter().map(|run| run.seconds).collect()) else {
                continue;
            };
            timings.push(Timing::new(job, times, runs.swap_remove(0).counters));
        }
        Ok(Timings { timings, bounds, left_out: fitted.left_out })
    }
}

/// Returns a bound to be measured for each n, with one thread and with all threads.
fn bounds_of(jobs: &[Job]) -> Vec<Bound> {
    let mut sizes: Vec<usize> = jobs.iter().map(|job| job.scene.n()).collect();
    sizes.sort_unstable();
    sizes.dedup();
    let mut threads = vec![1, cores()];
    threads.dedup();
    let mut bounds = Vec::new();
    for n in sizes {
        for &threads in &threads {
            bounds.push(Bound { n, threads, nanoseconds: f64::INFINITY });
        }
    }
    bounds
}

impl Bound {
    /// Measures a bound in one take.
    pub fn measured(n: usize, threads: usize) -> Self {
        Self { n, threads, nanoseconds: streaming::nanoseconds(n, threads) }
    }

    /// Measures the bound again, and keeps the shorter take.
    fn take(&mut self) {
        let again = Self::measured(self.n, self.threads);
        self.nanoseconds = self.nanoseconds.min(again.nanoseconds);
    }
}

impl Timings {
    /// Finds the timing of a job, with any number of steps.
    pub(crate) fn find(&self, job: &Job) -> Option<&Timing> {
        self.timings.iter().find(|timing| timing.job.is_but_for_steps(job))
    }

    /// Returns the streaming bound at `n` with one thread, or with all threads if `all`.
    pub(crate) fn bound(&self, n: usize, all: bool) -> f64 {
        let mut of_n = self.bounds.iter().filter(|bound| bound.n == n);
        let bound = if all { of_n.next_back() } else { of_n.next() };
        bound.map_or(f64::NAN, |bound| bound.nanoseconds)
    }

    /// Returns a line for each job that was not measured.
    pub(crate) fn left_out_in_words(&self) -> String {
        let lines = self
            .left_out
            .iter()
            .map(|(job, why)| format!("{} at n = {}: {why}\n", job.program, job.scene.n()));
        lines.collect()
    }

    /// Returns the streaming bounds as lines below a table.
    pub(crate) fn bounds_in_words(&self) -> String {
        let mut text = String::from("To read and write x, y, vx, vy of a particle takes at least");
        for Bound { n, threads, nanoseconds } in &self.bounds {
            let threads =
                if *threads == 1 { "one thread".into() } else { format!("{threads} threads") };
            text += &format!("\n  {} ns on {threads} at n = {n}", three_digits(*nanoseconds));
        }
        text
    }
}

impl Timing {
    fn new(job: Job, times: Times, counters: BTreeMap<String, f64>) -> Self {
        let nanoseconds = times.span(1e9 / (job.scene.n() as f64 * job.steps as f64));
        Self { ranks: job.ranks(), threads: job.threads(), job, times, counters, nanoseconds }
    }

    pub(crate) fn ms(&self) -> Span {
        self.times.span(1e3 / self.job.steps as f64)
    }

    /// Returns a counter divided by the number of steps; `None` if the program does not have it.
    pub(crate) fn per_step(&self, counter: &str) -> Option<f64> {
        self.counters.get(counter).map(|total| total / self.job.steps as f64)
    }
}
