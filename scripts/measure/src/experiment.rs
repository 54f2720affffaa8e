//! Experiments: jobs that take turns.
//!
//! A machine's speed drifts with its clock, its temperature and its neighbours. So jobs take
//! turns: each round runs every job once, and a bad minute hurts all of them. Every other round
//! goes backwards, so that no job always follows the same one. The yardstick takes part.

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

/// What all rounds together say about one job.
#[derive(Clone, Debug, Deserialize, Serialize)]
pub struct Record {
    /// What ran.
    #[serde(flatten)]
    pub job: Job,
    #[serde(skip_deserializing)]
    ranks: Option<usize>,
    #[serde(skip_deserializing)]
    threads: usize,
    /// Its times.
    #[serde(rename = "seconds")]
    pub times: Times,
    /// What the shortest run counted.
    pub counters: BTreeMap<String, f64>,
    /// By the shortest take and by the median.
    #[serde(rename = "nanoseconds_per_particle_and_step")]
    pub nanoseconds: Span,
}

/// Nanoseconds per particle of the streaming bound.
#[derive(Clone, Copy, Debug, Deserialize, Serialize)]
pub struct Bound {
    /// Particles.
    pub n: usize,
    /// Threads.
    pub threads: usize,
    /// The shortest take.
    pub nanoseconds: f64,
}

/// What all rounds together say.
pub struct Records {
    /// In the order of the jobs.
    pub records: Vec<Record>,
    /// By ascending n, one thread and all.
    pub bounds: Vec<Bound>,
    /// Jobs that were not measured, and why.
    pub left_out: LeftOut,
}

/// The turn order of a round: forwards, and every other round backwards.
pub fn turns(count: usize, round: usize) -> Vec<usize> {
    let mut order: Vec<usize> = (0..count).collect();
    if round % 2 == 1 {
        order.reverse();
    }
    order
}

/// Lets `items` take turns, `rounds` times, behind a bar that names them. Returns what each came to,
/// round by round.
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

impl Effort {
    /// Runs all jobs, and the yardstick, round after round.
    ///
    /// # Errors
    /// A job fails.
    pub fn run(&self, runner: &Runner, jobs: Vec<Job>, fit: Fit) -> Result<Records> {
        if self.steps.is_none() {
            let (runs, seconds) = (jobs.len() * usize::from(self.rounds), self.seconds);
            eprintln!(
                "{runs} runs in some {seconds} s, after trying out how many steps each may have"
            );
        }
        let (jobs, left_out) = self.fitted(runner, jobs, fit)?;
        let mut bounds = bounds_of(&jobs);
        let name = |job: &Job| format!("{} n={}", job.program, job.scene.n());
        let mut left = jobs.len();
        let outcomes = in_turns(&jobs, self.rounds.into(), name, |job| {
            let outcome = runner.run(job)?;
            left -= 1;
            if left == 0 {
                left = jobs.len();
                for bound in &mut bounds {
                    let take = streaming::nanoseconds(bound.n, bound.threads);
                    bound.nanoseconds = bound.nanoseconds.min(take);
                }
            }
            Ok(outcome)
        })?;
        let records = jobs.iter().zip(outcomes).filter_map(|(job, mut outcomes)| {
            outcomes.sort_by(|a, b| a.seconds.total_cmp(&b.seconds));
            let times = Times::of(outcomes.iter().map(|outcome| outcome.seconds).collect())?;
            Some(Record::new(job.clone(), times, outcomes.swap_remove(0).counters))
        });
        Ok(Records { records: records.collect(), bounds, left_out })
    }
}

/// A bound to be measured for each n, on one thread and on all.
fn bounds_of(jobs: &[Job]) -> Vec<Bound> {
    let mut sizes: Vec<usize> = jobs.iter().map(|job| job.scene.n()).collect();
    sizes.sort_unstable();
    sizes.dedup();
    let mut threads = vec![1, cores()];
    threads.dedup();
    let bound = |n, threads| Bound { n, threads, nanoseconds: f64::INFINITY };
    sizes.into_iter().flat_map(|n| threads.iter().map(move |&t| bound(n, t))).collect()
}

impl Records {
    /// What came of a job.
    pub fn find(&self, job: &Job) -> Option<&Record> {
        self.records.iter().find(|record| record.job.is_but_for_steps(job))
    }

    /// The streaming bound at `n`: one thread's, or all threads' if `all`.
    pub fn bound(&self, n: usize, all: bool) -> f64 {
        let mut of_n = self.bounds.iter().filter(|bound| bound.n == n);
        let bound = if all { of_n.next_back() } else { of_n.next() };
        bound.map_or(f64::NAN, |bound| bound.nanoseconds)
    }

    /// A line for each job that was not measured.
    pub fn left_out_in_words(&self) -> String {
        let line = |(job, why): &(Job, String)| {
            format!("{} at n = {}: {why}\n", job.program, job.scene.n())
        };
        self.left_out.iter().map(line).collect()
    }

    /// The streaming bounds as lines to stand below a table.
    pub fn bounds_in_words(&self) -> String {
        let mut text = String::from("To read and write x, y, vx, vy of a particle takes at least");
        for Bound { n, threads, nanoseconds } in &self.bounds {
            let threads =
                if *threads == 1 { "one thread".into() } else { format!("{threads} threads") };
            text += &format!("\n  {} ns on {threads} at n = {n}", three_digits(*nanoseconds));
        }
        text
    }
}

impl Record {
    fn new(job: Job, times: Times, counters: BTreeMap<String, f64>) -> Self {
        let nanoseconds = times.span(1e9 / (job.scene.n() as f64 * job.steps as f64));
        Self { ranks: job.ranks(), threads: job.threads(), job, times, counters, nanoseconds }
    }

    /// Milliseconds of a step.
    pub fn ms(&self) -> Span {
        self.times.span(1e3 / self.job.steps as f64)
    }

    /// What was counted under this name, per step.
    pub fn per_step(&self, counter: &str) -> Option<f64> {
        self.counters.get(counter).map(|total| total / self.job.steps as f64)
    }
}
